# shellcheck shell=bash
# A browser without a display, for the scripts of this folder that source this: it is driven by WebDriver
# (www.w3.org/TR/webdriver2). Brings common.sh with it.
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/common.sh"
driver=
end_browser() {
  [[ -n ${session-} ]] && request DELETE "/session/$session" >/dev/null 2>&1
  [[ -n $driver ]] && kill "$driver" 2>/dev/null && wait "$driver" 2>/dev/null
}
trap 'end_browser; clean_up' EXIT

for tool in chromium chromedriver; do
  command -v $tool >/dev/null || fail "$tool is not installed (apt-get install chromium chromium-driver)"
done

# request METHOD PATH [BODY]: prints the driver's answer (WebDriver, www.w3.org/TR/webdriver2).
request() {
  local body=${3-} line length=0
  exec 3<>"/dev/tcp/127.0.0.1/$port" || return 1
  printf '%s %s HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\nContent-Length: %d\r\n\r\n%s' \
    "$1" "$2" "$(printf %s "$body" | wc -c)" "$body" >&3
  while IFS= read -r line <&3 && [[ $line != $'\r' ]]; do
    [[ ${line,,} == content-length:* ]] && length=${line#*:}
  done
  head -c "$((${length//[$' \r']/}))" <&3
  exec 3>&-
}

# js SCRIPT: what it returns; it must do without double quotes and backslashes.
js() {
  request POST "/session/$session/execute/sync" "{\"script\": \"$(tr '\n' ' ' <<<"$1")\", \"args\": []}" |
    sed 's/^{"value":"\?//; s/"\?}$//'
}

# expect WANTED SCRIPT: tries for some seconds.
expect() {
  local found try
  for try in $(seq 100); do
    found=$(js "$2")
    [[ $found == "$1" ]] && return
    sleep 0.1
  done
  fail "found \"$found\" instead of \"$1\": $2"
}

# start_browser: from here on there is a page to look at.
start_browser() {
  TMPDIR=$folder chromedriver --port=0 >"$folder/driver.log" 2>&1 &
  driver=$!
  wait_until grep -qs "successfully on port" "$folder/driver.log" || fail "chromedriver did not start"
  port=$(sed -n 's/.*successfully on port \([0-9]*\).*/\1/p' "$folder/driver.log")
  sandbox=
  ((EUID == 0)) && sandbox=', "--no-sandbox"'
  # Driver and browser talk through a pipe: a fresh machine without /etc/hosts does not know localhost.
  session=$(request POST /session '{"capabilities": {"alwaysMatch": {"goog:loggingPrefs": {"browser": "ALL"},
    "goog:chromeOptions": {"args": ["--headless=new", "--remote-debugging-pipe", "--disable-gpu", "--window-size=1200,900"'"$sandbox"']}}}}' |
    grep -o '"sessionId":"[^"]*"' | cut -d '"' -f 4)
  [[ -n $session ]] || fail "chromium did not start"
}

# open_page FILE
open_page() {
  local address
  address=$(printf %s "$1" | od -An -v -tx1 | tr -d '\n' | tr ' ' %)
  request POST "/session/$session/url" "{\"url\": \"file://${address//%2f//}\"}" >/dev/null
}

# browser_log: what the console says, as JSON; an empty list where it says nothing.
browser_log() { request POST "/session/$session/se/log" '{"type": "browser"}'; }
