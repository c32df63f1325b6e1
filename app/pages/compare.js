// Every figure to blink shows the other picture of its pair twice a second.
let odd = false;
function show() {
  for (const pair of document.querySelectorAll(".pair"))
    pair.querySelector(".blink").src = pair.querySelector(odd ? ".b" : ".a").src;
  odd = !odd;
}
show();
setInterval(show, 500);
