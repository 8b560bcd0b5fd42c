// SPDX-License-Identifier: BSL-1.0
#include "report.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <riprap/output/file.hpp>

#include "../claims/causes.hpp"
#include "../claims/requirements.hpp"
#include "../figures/figures.hpp"
#include "../rockfill/rockfill.hpp"
#include "claim_section.hpp"
#include "result_tables.hpp"

namespace report {

namespace {

constexpr auto title = "The paper's study, repeated with riprap";

void add(Document& document, const std::string& text) { document.push_back(Paragraph{text}); }

// Whether all runs of a sample began their hydrostatic stage alike.
std::string start_text(const Results& results) {
  std::map<int, std::set<std::string>> states;
  for (const Run& run : results.runs) states[run.seed].insert(run.relaxed_state);
  const bool alike =
      std::all_of(states.begin(), states.end(), [](const auto& s) { return s.second.size() == 1; });
  return alike ? "All runs of a sample start from the same relaxed state, to the last bit."
               : "Runs of a sample do **not** all start from the same relaxed state, so that "
                 "differences between them are larger than they should be.";
}

void add_introduction(Document& document, const Results& results) {
  std::set<int> samples;
  double time = 0;
  for (const Run& run : results.runs) {
    samples.insert(run.seed);
    time += run.wall_time;
  }
  document.push_back(Heading{1, title, ""});
  add(document,
      "A. Bagherzadeh-Khalkhali, A. A. Mirghasemi and S. Mohammadi, *Micromechanics of breakage in "
      "sharp-edge particles using combined DEM and FEM*, Particuology 6 (2008), \"the paper\" "
      "below, simulate biaxial tests on assemblies of sharp particles at six confining pressures, "
      "without breakage (NB) and with breakage (WB). This page repeats that study, shows the "
      "counterpart of each of its figures, and judges each of its statements of result. " +
          start_text(results) +
          (results.has(Mode::pinned)
               ? " A third series, \"pinned\", supports a particle in its stress analysis as the "
                 "paper does, by pinning two of its contacts; WB leaves it free and lets its "
                 "inertia balance the loads."
               : ""));
  add(document,
      "This page was written from " + std::to_string(results.runs.size()) + " runs of " +
          std::to_string(results.runs.front().particles) + " particles, with " +
          std::to_string(samples.size()) + (samples.size() == 1 ? " sample" : " samples") +
          " of each series; the runs took " + std::to_string(static_cast<long>(time / 60 + 0.5)) +
          " minutes of one processor core.");
  if (samples.size() == 1)
    add(document,
        "One sample has no scatter to judge by, so that nearly all claims are left open: this is a "
        "trial of the study and not its result.");
}

void add_summary(Document& document, const std::vector<ShownClaim>& claims, bool pinned) {
  document.push_back(Heading{2, "What holds and what does not", "summary"});
  add(document, count_text(claims));
  add(document,
      "Every verdict is computed from the runs by the rule that stands with the claim. A "
      "difference "
      "counts where Student's one-sided test over the samples has it with 95 %; two series are "
      "compared sample by sample. **holds**: all that the rule asks for is found. **holds in "
      "part**: some of it, for instance at high pressures only. **does not hold**: none of it; the "
      "reason says whether the runs show the opposite, or nothing that stands out from the scatter "
      "of the samples. Where a statement says that something does not happen, that nothing clear "
      "speaks against it is enough." +
          std::string(pinned ? " The last column judges the same with two contacts pinned." : ""));
  document.push_back(summary_table(claims));
}

void add_requirements(Document& document, const Results& results,
                      const std::filesystem::path& folder) {
  document.push_back(Heading{2, "Four outcomes, by the means of the samples", "outcomes"});
  add(document,
      "The main results of the paper by the means alone, whatever the scatter; the last of them in "
      "the mean and, more strictly, at every pressure.");
  const std::vector<Requirement> all = requirements(results);
  document.push_back(requirements_table(all));
  const bool failed =
      std::any_of(all.begin(), all.end(), [](const Requirement& r) { return r.met == Met::no; });
  if (!failed) return;
  const Table causes = causes_table(results, folder);
  if (causes.rows.empty()) return;
  add(document,
      "Eq. 14 leaves out the anisotropy of the branch vectors, which slender pieces have; the full "
      "relation has it. One run a suspected cause, all with breakage, sample 1; distances are "
      "means "
      "over the curve, the scatter is the standard deviation over the samples:");
  document.push_back(causes);
}

// Parameters of a run with breakage, which has them all, where there is one.
Json run_parameters(const Results& results) {
  const Run& run = results.runs.back();
  const Json json = read_json(run.folder / "run.json");
  return json.contains("parameters") ? json.at("parameters") : Json::object();
}

void add_parameters(Document& document, const Results& results) {
  document.push_back(
      Heading{2, "Parameters: what the paper gives, and what it leaves open", "parameters"});
  add(document,
      "The equations are used as `docs/choices.md` puts them right; it also gives the "
      "reasons at length. Compression and contraction are positive, and axis 2 is loaded.");
  document.push_back(parameters_table(run_parameters(results)));
}

void add_results(Document& document, const Results& results) {
  document.push_back(Heading{2, "Results in numbers", "results"});
  add(document,
      "Means over the samples, in brackets the least and the largest. \"At the end\" is the mean "
      "over the last 5 % of axial strain. The gap of a relation is its mean distance from the "
      "measured sin phi, eq. 12, from 1 % of strain on; the full relation is eq. 14 with the "
      "anisotropies of the branch vectors. Breakages are those of the hydrostatic stage and of "
      "shear; they depend on the rule for slivers, the mesh and round-off, so that stress, volume "
      "and coordination are what to judge by.");
  document.push_back(results_table(results));
  add(document,
      "How quasi-static the runs were, and how stiff the contacts: kappa is pressure times "
      "thickness over normal stiffness; energies are compared from 1 % of strain on.");
  document.push_back(quality_table(results));
  std::map<std::string, std::string> warnings;
  for (const Run& run : results.runs)
    for (const std::string& warning : run.warnings)
      warnings[warning] += (warnings[warning].empty() ? "" : "; ") + run.name();
  if (warnings.empty()) return;
  add(document, "Warnings of the runs:");
  List list;
  for (const auto& [warning, runs] : warnings) list.items.push_back(warning + " (" + runs + ")");
  document.push_back(list);
}

void add_figures(Document& document, const Results& results, const std::vector<ShownClaim>& claims,
                 const std::filesystem::path& folder) {
  document.push_back(Heading{2, "Figures 3 to 21, and the claims that go with them", "figures"});
  add(document,
      "Numbers are those of the paper. Pictures of particles show the first sample. In tables of "
      "what was measured ± is the standard error of the mean; ✓ marks what agrees with the "
      "statement, ✗ what is against it, ~ what the scatter of the samples leaves open; numbers "
      "without a mark are shown for comparison only.");
  for (const Figure& figure : figures(results, folder)) {
    document.push_back(Heading{3, "Fig. " + std::to_string(figure.number) + ": " + figure.title,
                               "fig-" + std::to_string(figure.number)});
    for (const Pictures& row : figure.rows) document.push_back(row);
    if (!figure.text.empty()) add(document, figure.text);
    add_claims(document, claims, figure.number);
  }
}

// The section on rockfill: strength, breakage, gradings, stiffness.
void add_rockfill(Document& document, const Results& results) {
  std::vector<Json> runs;
  for (const Run& run : results.runs) runs.push_back(read_json(run.folder / "run.json"));
  const rockfill::Findings found = rockfill::findings(runs);
  document.push_back(Heading{2, "For rockfill engineers", "rockfill"});
  add(document,
      "The same runs in the terms of those who build with rock. Two-dimensional samples of one "
      "narrow grading are no substitute for tests; what can be compared is how strength falls with "
      "stress.");
  for (std::size_t i = 0; i < found.charts.size(); ++i)
    document.push_back(Pictures{{{"rockfill_" + std::to_string(i + 1), "",
                                  riprap::chart_sheet({found.charts[i]}).document()}}});
  for (const rockfill::Table& table : found.tables) {
    add(document, "**" + table.title + "**");
    document.push_back(Table{table.head, table.rows});
  }
  document.push_back(List{found.notes});
}

void add_repeating(Document& document) {
  document.push_back(Heading{2, "How to repeat it", "repeat"});
  document.push_back(
      Code{"examples/run paper             # all of it; an interrupted study goes on\n"
           "examples/run paper --quick     # a few small samples, in some minutes\n"});
  add(document,
      "leaves `report.html`, which is this page with its pictures in one file, `claims.json` with "
      "every claim, rule, number and verdict, and a folder for every run. A finished run is not "
      "made again, and the report is written from the files of the runs alone. The same input "
      "gives the same bytes on every machine of the same architecture, whatever the compiler.");
}

Document document_of(const Results& results, const std::vector<ShownClaim>& claims,
                     const std::filesystem::path& folder) {
  Document document;
  add_introduction(document, results);
  add_summary(document, claims, results.has(Mode::pinned));
  add_requirements(document, results, folder);
  add_parameters(document, results);
  add_results(document, results);
  add_figures(document, results, claims, folder);
  add_rockfill(document, results);
  add_repeating(document);
  return document;
}

}  // namespace

}  // namespace report

void write_report(const std::filesystem::path& folder) {
  const report::Results results = report::read_results(folder);
  const std::vector<report::ShownClaim> claims = report::shown_claims(results, folder);
  const report::Document document = report::document_of(results, claims, folder);

  report::Json json = report::Json::array();
  for (const report::ShownClaim& claim : claims) json.push_back(claim.json);
  riprap::write_file((folder / "claims.json").string(), json.dump(2) + "\n");
  riprap::write_file((folder / "report.html").string(), to_html(document, report::title));
  riprap::write_file((folder / "paper.md").string(), to_markdown(document, "images/paper"));
  save_pictures(document, folder / "images" / "paper");
}
