#include "app/commands/compare_options.hpp"

#include <string>

namespace spindrift::app {

void add_compare_options(CLI::App& command, CompareOptions& options) {
  const auto add_path = [&](const char* name, std::filesystem::path& path) {
    command
        .add_option(name, path, "A PNG, a folder of PNGs, a video, or a folder that render made")
        ->required();
  };
  add_path("A", options.a);
  add_path("B", options.b);
  command.add_option("-o,--out", options.output, "Folder for the report and the differences")
      ->type_name("DIR")
      ->capture_default_str();
  const auto add_limit = [&](const char* name, std::optional<double>& limit, double most,
                             const char* about) {
    command.add_option(name, limit, about)->type_name("LIMIT")->check(CLI::Range(0., most));
  };
  add_limit("--max-flip", options.limits.max_flip, 1, "Largest mean of FLIP in any pair, 0 to 1");
  add_limit("--max-changed", options.limits.max_changed, 1,
            "Largest share of changed pixels in any pair, 0 to 1");
  add_limit("--min-ssim", options.limits.min_ssim, 1, "Least SSIM of any pair, 0 to 1");
  add_limit("--min-psnr", options.limits.min_psnr, 1000, "Least PSNR of any pair, dB");
  command
      .add_option("--threshold", options.threshold,
                  "A pixel has changed where a channel is off by more, of 255")
      ->type_name("LEVELS")
      ->check(CLI::Range(0, 254))
      ->capture_default_str();
  command
      .add_option("--show", options.shown_pairs, "Pairs whose pictures the report shows, the worst")
      ->type_name("N")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  command.add_flag("--quiet", options.quiet, "Print nothing but errors");
  command.add_flag("--json", options.json, "Print for machines");
}

void add_golden_options(CLI::App& command, GoldenOptions& options) {
  command
      .add_option_function<std::string>(
          "action",
          [&](const std::string& action) {
            options.action = action == "update" ? GoldenAction::update : GoldenAction::check;
          },
          "Compare with the references, or make them")
      ->required()
      ->type_name("ACTION")
      ->check(CLI::IsMember({"check", "update"}));
  command.add_option("list", options.list, "List of golden tests")->required()->type_name("FILE");
  command.add_option("-o,--out", options.output, "Folder for the results and the report")
      ->type_name("DIR")
      ->capture_default_str();
  command.add_option("--only", options.only, "Only the golden tests of these names")
      ->type_name("NAME,...")
      ->delimiter(',')
      ->expected(1)
      ->take_all();
  command
      .add_option("--set", options.overrides,
                  "With check: set a value of every scene, to see whether the change is noticed")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->take_all();
  command.add_flag("--quiet", options.quiet, "Print nothing but errors");
  command.add_flag("--json", options.json, "Print for machines");
}

}  // namespace spindrift::app
