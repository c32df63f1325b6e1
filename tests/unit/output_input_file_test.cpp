#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <fstream>

#include "output_support.hpp"
#include "render/output/input_file.hpp"

namespace output_input_file_tests {

using namespace spindrift;
using output_test::TemporaryFolder;

TEST_CASE("a file's bytes are read whole, zeros among them") {
  const TemporaryFolder folder;
  const std::string bytes("a\0b\n\xff", 5);
  std::ofstream(folder / "file", std::ios::binary) << bytes;
  REQUIRE(output::read_file(folder / "file") == bytes);
  std::ofstream(folder / "empty", std::ios::binary).close();
  REQUIRE(output::read_file(folder / "empty").empty());
}

TEST_CASE("what is no regular file is refused at once, in words") {
  const TemporaryFolder folder;
  const auto reason = [](const std::filesystem::path& file) {
    try {
      output::require_regular_file(file);
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  const std::filesystem::path pipe = folder / "pipe";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  CHECK(reason(pipe) == pipe.string() + ": is a pipe (FIFO), not a file");
  CHECK(reason("/dev/null") == "/dev/null: is a device, not a file");
  CHECK(reason(folder / "") == (folder / "").string() + ": is a folder, not a file");
  CHECK(reason(folder / "none") == (folder / "none").string() + ": there is no such file");
  REQUIRE_THROWS(output::read_file(pipe));
}

}  // namespace output_input_file_tests
