// SPDX-License-Identifier: BSL-1.0
#include "report.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <riprap/output/file.hpp>

#include "../claims/requirements.hpp"
#include "../claims/study_rows.hpp"
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
  for (const Run& run : results.rows) time += run.wall_time;
  std::size_t fewest = samples.size();
  for (const Run& run : results.runs)
    fewest = std::min(fewest, results.of(run.mode, run.pressure).size());
  std::string sample_count = std::to_string(fewest);
  if (fewest < samples.size()) sample_count += " to " + std::to_string(samples.size());
  sample_count += samples.size() == 1 ? " sample" : " samples";
  document.push_back(Heading{1, title, ""});
  add(document,
      "A. Bagherzadeh-Khalkhali, A. A. Mirghasemi and S. Mohammadi, *Micromechanics of breakage in "
      "sharp-edge particles using combined DEM and FEM*, Particuology 6 (2008), \"the paper\" "
      "below, simulate biaxial tests on assemblies of sharp particles at six confining pressures, "
      "without breakage (NB) and with breakage (WB). This page repeats that study, shows the "
      "counterpart of each of its figures, and judges each of its statements of result. " +
          start_text(results));
  add(document, "This page was written from " + std::to_string(results.runs.size()) + " runs of " +
                    std::to_string(results.runs.front().particles) + " particles and " +
                    std::to_string(results.rows.size()) + " runs that change one thing, with " +
                    sample_count + " of each series; the runs took " +
                    std::to_string(static_cast<long>(time / 60 + 0.5)) +
                    " minutes of one processor core.");
  if (samples.size() == 1)
    add(document,
        "One sample has no scatter to judge by, so that nearly all claims are left open: this is a "
        "trial of the study and not its result.");
}

// Of how many tests how many are expected to show what is not there.
std::string chance_text(const std::vector<ShownClaim>& claims) {
  std::size_t tests = 0;
  for (const ShownClaim& c : claims)
    if (c.json.contains("tests")) tests += c.json.at("tests").size();
  const double expected = (1 - test_level) * static_cast<double>(tests);
  return "The verdicts rest on " + std::to_string(tests) +
         " tests: were there no effects at all, " +
         std::to_string(static_cast<long>(std::lround(expected))) +
         " of them would be expected to show one by chance.";
}

void add_summary(Document& document, const std::vector<ShownClaim>& claims) {
  document.push_back(Heading{2, "What holds and what does not", "summary"});
  add(document, count_text(claims));
  add(document,
      "Every verdict is computed from the runs by the rule that stands with the claim. A claim has "
      "one part or several, and each part one test: Student's, one-sided, with 95 %, of a number "
      "that pools all series and pressures the part speaks of, such as the mean of paired "
      "differences or the slope over the logarithm of pressure. The unit is the sample: the number "
      "is computed for each sample that all these runs have, so that what the runs of one sample "
      "share is not counted as evidence twice. The table by pressure under a claim is evidence; "
      "there a mark needs 95 % for all entries of the part together (Bonferroni).");
  document.push_back(
      List{{"**holds**: every part is shown, and no single series and pressure is clearly the "
            "other way.",
            "**holds in part**: a part is shown, but another is not, or not everywhere, or the "
            "effect is shown to be less than the margin that the rule states.",
            "**open**: nothing is shown and nothing is refuted.",
            "**does not hold**: nothing is shown, and of some part the opposite is shown, or that "
            "its effect is less than the margin."}});
  add(document, chance_text(claims));
  document.push_back(summary_table(claims));
}

void add_requirements(Document& document, const Results& results) {
  document.push_back(Heading{2, "Four outcomes, by the means of the samples", "outcomes"});
  add(document,
      "The main results of the paper by the means alone, whatever the scatter; the last of them in "
      "the mean and, more strictly, at every pressure.");
  document.push_back(requirements_table(requirements(results)));
}

void add_rows(Document& document, const Results& results) {
  const Table table = rows_table(results);
  if (table.rows.empty()) return;
  document.push_back(Heading{2, "What brings the paper's trends, and what does not", "rows"});
  add(document,
      "Each row changes one thing that the paper leaves open, or has otherwise. Means over the "
      "samples; a, a_n and a_t in the mean over shear from 1 % of strain on, gaps as in the table "
      "of results.");
  document.push_back(table);
  add(document,
      "The same less the series, sample by sample, with the standard error; bold is what Student's "
      "two-sided test has with 95 %, of which one in twenty is expected by chance. Blunt "
      "particles, periodic cells and ten times as many particles are samples of their own: a pair "
      "of them with the same number has nothing in common.");
  document.push_back(row_changes_table(results));
  if (const std::string text = softness_text(results); !text.empty()) add(document, text);
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
      "thickness over normal stiffness; energies are compared from 1 % of strain on. A crack costs "
      "nothing in the model; the table has what it would cost at 100 J per square metre of crack, "
      "as of granite, over the work of the boundary in shear.");
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
  add_summary(document, claims);
  add_requirements(document, results);
  add_rows(document, results);
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
