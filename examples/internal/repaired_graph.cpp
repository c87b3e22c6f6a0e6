#include "repaired_graph.h"

Graph repaired_graph(const Graph& graph, CGAL::Pslg_repair_report_2& report) {
  const auto options = CGAL::Pslg_repair_options_2().crossings(CGAL::Pslg_crossing_rule_2::SPLIT);
  return CGAL::repair_pslg_2(graph, options, report);
}
