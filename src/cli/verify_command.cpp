#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "archive/store/archive_json.h"
#include "cli/archive_commands.h"
#include "inspect/survey/text_table.h"

namespace tribolog::cli {

Run add_verify(CLI::App& archive) {
  struct Options {
    std::string head;
    bool json{false};
  };
  const auto options = std::make_shared<Options>();
  CLI::App& command =
      *archive.add_subcommand("verify", "prove that nothing in it was lost or altered");
  command.add_option("--head", options->head,
                     "a head reported by an earlier verify: nothing before it may be lost");
  const auto where = add_archive_options(command);
  command.add_flag("--json", options->json, "as JSON, to standard output");
  command.footer(
      "\nEach calibration has a digest of its contents, each addition and removal is a link in "
      "a\nchain. The last link, the head, identifies the state of the archive: written down, it "
      "proves\nlater that nothing up to it was lost. Status 6 if something is wrong.");
  return [where, options](const Invocation& call) {
    const auto outcome = where->open(archive::sql::Access::read)
                             .verify(options->head, [&](std::size_t done, std::size_t all) {
                               call.console.progress("verifying", done, all);
                             });
    call.console.finish();
    if (options->json) {
      print_json(archive::store::verification_json(outcome));
    } else if (outcome.faults.empty()) {
      call.console.say(fmt::format("whole: {}, {}, {} of the chain\nhead: {}",
                                   inspect::survey::plural(outcome.entries, "calibration"),
                                   inspect::survey::plural(outcome.documents, "document"),
                                   inspect::survey::plural(outcome.events, "link"), outcome.head));
    }
    for (const std::string& fault : outcome.faults) {
      call.console.warn("damaged: " + printable(fault, 400));
    }
    return outcome.faults.empty() ? ExitStatus::done : ExitStatus::archive_failed;
  };
}

}  // namespace tribolog::cli
