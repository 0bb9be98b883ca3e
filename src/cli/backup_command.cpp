#include <CLI/CLI.hpp>

#include "cli/archive_commands.h"

namespace tribolog::cli {

Run add_backup(CLI::App& archive) {
  const auto output = std::make_shared<std::string>();
  CLI::App& command = *archive.add_subcommand("backup", "a copy in a file of its own");
  command.add_option("-o,--output", *output, "file to write; none may be there")->required();
  const auto where = add_archive_options(command);
  command.footer("\nOthers may go on archiving meanwhile: the copy is of one moment.");
  return [where, output](const Invocation& call) {
    if (*output == "-") {
      throw UsageError("archive backup: a backup is a database, which needs a file of its own");
    }
    where->protect_from(*output);
    where->open(archive::sql::Access::read).backup(*output);
    call.console.say("backup: " + printable(*output, longest_path));
    return ExitStatus::done;
  };
}

}  // namespace tribolog::cli
