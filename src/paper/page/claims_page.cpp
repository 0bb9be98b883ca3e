#include "paper/page/claims_page.h"

#include <utility>

#include <nlohmann/json.hpp>

#include "paper/page/page_parts.h"
#include "report/document/report_values.h"
#include "report/document/view_parts.h"
#include "report/elements/element_values.h"
#include "report/elements/elements.h"
#include "report/elements/figure_cards.h"
#include "report/engine/page_style.h"
#include "report/engine/template_engine.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::paper::page {

namespace {

using Json = nlohmann::ordered_json;
using wording::tr;

Json json_of(const claims::Finding& finding) {
  return {{"holds", finding.holds ? Json(*finding.holds) : Json(nullptr)},
          {"found", finding.found}};
}

std::string outcome_word(const claims::Finding& finding) {
  if (!finding.holds) return tr("not asked");
  return *finding.holds ? tr("holds") : tr("does not hold");
}

const char* state_of(const claims::Finding& finding) {
  if (!finding.holds) return "absent";
  return *finding.holds ? "holds" : "fails";
}

void fill_verdict(const ArguedPaper& paper, report::engine::TemplateValues& values) {
  const ClaimTally here = tally_of(paper.claims, false);
  const ClaimTally there = tally_of(paper.claims, true);
  report::engine::TemplateValues& verdict = values.add_include("VERDICT", "verdict.tpl");
  const bool all_hold = here.hold == here.asked;
  verdict.set("WORD", here.asked == 0 ? tr("NO CLAIM CAN BE ASKED")
                      : all_hold      ? tr("ALL CLAIMS HOLD HERE")
                                      : tr("NOT ALL CLAIMS HOLD HERE"));
  verdict.set("SENTENCE",
              tr("{hold} of {asked} claims hold on this joint, {papers_hold} of {papers_asked} on "
                 "the paper's.",
                 {{"hold", here.hold},
                  {"asked", here.asked},
                  {"papers_hold", there.hold},
                  {"papers_asked", there.asked}}));
  report::elements::fill_outcome(here.asked == 0 ? report::elements::Outcome::absent
                                 : all_hold      ? report::elements::Outcome::good
                                                 : report::elements::Outcome::partial,
                                 verdict);
  report::engine::TemplateValues* list = nullptr;
  for (const claims::Claim& claim : paper.claims) {
    if (!claim.on_papers_joint.holds || !claim.on_this_joint.holds ||
        *claim.on_papers_joint.holds == *claim.on_this_joint.holds) {
      continue;
    }
    if (list == nullptr) list = &verdict.add_section("FINDINGS");
    list->add_section("FINDING").set(
        "TEXT", *claim.on_this_joint.holds
                    ? tr("{claim}: here it holds, on the paper's joint it does not "
                         "({found}).",
                         {{"claim", claim.what}, {"found", claim.on_papers_joint.found}})
                    : tr("{claim}: here it does not hold ({found}), on the paper's joint it "
                         "does.",
                         {{"claim", claim.what}, {"found", claim.on_this_joint.found}}));
  }
}

void fill_claims(const std::vector<claims::Claim>& all, report::engine::TemplateValues& values) {
  for (const claims::Claim& claim : all) {
    report::engine::TemplateValues& row = values.add_section("CLAIM");
    row.set("WHERE", claim.is_ours ? tr("tribolog") : claim.where);
    row.set("WHAT", claim.what);
    row.set("PAPERS_STATE", state_of(claim.on_papers_joint));
    row.set("PAPERS_OUTCOME", outcome_word(claim.on_papers_joint));
    row.set("PAPERS_FOUND", claim.on_papers_joint.found);
    row.set("STATE", state_of(claim.on_this_joint));
    row.set("OUTCOME_HERE", outcome_word(claim.on_this_joint));
    row.set("FOUND", claim.on_this_joint.found);
  }
}

}  // namespace

ClaimTally tally_of(const std::vector<claims::Claim>& claims, bool on_papers_joint) {
  ClaimTally out;
  for (const claims::Claim& claim : claims) {
    const claims::Finding& finding = on_papers_joint ? claim.on_papers_joint : claim.on_this_joint;
    if (!finding.holds) continue;
    ++out.asked;
    out.hold += *finding.holds ? 1 : 0;
  }
  return out;
}

std::string claims_json(const ArguedPaper& paper) {
  Json list = Json::array();
  for (const claims::Claim& claim : paper.claims) {
    list.push_back({{"of", claim.is_ours ? "tribolog" : "paper"},
                    {"where", claim.where},
                    {"claim", claim.what},
                    {"papers_joint", json_of(claim.on_papers_joint)},
                    {"this_joint", json_of(claim.on_this_joint)}});
  }
  const Json whole{{"schema", "tribolog-claims-1"},
                   {"tool", paper.provenance.tool_version},
                   {"joint", paper.joint},
                   {"claims", std::move(list)}};
  return whole.dump();
}

std::string claims_page(const ArguedPaper& paper, const calibration::Calibration& calibration,
                        const std::vector<render::workers::DrawnFigure>& drawn,
                        const std::string& json, wording::Language language) {
  report::engine::TemplateValues values;
  report::engine::fill_head(paper.provenance, values);
  values.set("JOINT", paper.joint);
  fill_verdict(paper, values);
  fill_claims(paper.claims, values);
  for (const report::elements::FigureCard& card :
       report::elements::figure_cards(paper.figures, drawn)) {
    report::elements::fill_figure(card, values);
  }
  report::elements::fill_table(table_2(calibration), "TABLE", values);
  fill_selection(calibration, values);
  values.set("FILE_NAME", paper.source.name);
  values.set("FILE_TEXT", paper.source.text);
  report::document::fill_provenance(
      paper.provenance.command_line, wording::or_dash(paper.provenance.created_utc), {},
      report::document::provenance_tables(calibration, paper.provenance), values);
  values.set_checked_by_modifier("RESULT_JSON", json);
  return report::engine::expand_template("paper_claims.tpl", values, language);
}

}  // namespace tribolog::paper::page
