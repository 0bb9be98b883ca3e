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
      *archive.add_subcommand("verify", "proves that nothing in it was lost or altered");
  command.add_option("--head", options->head,
                     "a head that an earlier verify told: nothing before it may be lost");
  const auto where = add_archive_options(command);
  command.add_flag("--json", options->json, "as JSON, to standard output");
  command.footer(
      "\nEach calibration has a digest over all it says, each addition and removal is a link of a\n"
      "chain. The last link, the head, names the state of the archive: written down, it proves\n"
      "later that nothing up to it was lost. Status 6 where something is wrong.");
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
