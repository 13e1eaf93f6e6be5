// Computes the numbers that the report must show, with SQL statements on a campaign's database and without isolaw.
// `expected_numbers STORE` prints them as JSON. docs/method.md defines the statistics: means and sample standard
// deviations over the runs that have an objective, and the robustness index beta. Beta is the mean over the free
// parameters of the largest relative difference between a device's mean and the lot's mean.
#include <sqlite3.h>

#include <cstdio>
#include <cstdlib>

namespace {

constexpr char const* question = R"sql(
WITH usable AS (
  SELECT r.device, r.law, r.number, r.objective FROM run AS r
  WHERE EXISTS (SELECT 1 FROM run_parameter AS v WHERE v.device = r.device AND v.law = r.law AND v.number = r.number)),
fit AS (
  SELECT device, law, count(*) AS n, avg(objective) AS mean, min(objective) AS best FROM usable GROUP BY device, law),
fit_std AS (
  SELECT f.*, CASE WHEN f.n > 1 THEN sqrt(sum((u.objective - f.mean) * (u.objective - f.mean)) / (f.n - 1)) END AS std
  FROM fit AS f JOIN usable AS u USING (device, law) GROUP BY f.device, f.law),
law_mean AS (SELECT law, avg(mean) AS mean FROM fit GROUP BY law),
value AS (
  SELECT p.device, p.law, p.position, p.name, avg(v.value) AS mean, count(*) AS n
  FROM search_parameter AS p JOIN run_parameter AS v USING (device, law, position) WHERE p.free GROUP BY p.device, p.law, p.position),
value_std AS (
  SELECT m.*, CASE WHEN m.n > 1 THEN sqrt(sum((v.value - m.mean) * (v.value - m.mean)) / (m.n - 1)) END AS std
  FROM value AS m JOIN run_parameter AS v USING (device, law, position) GROUP BY m.device, m.law, m.position),
lot AS (SELECT law, position, avg(mean) AS mean FROM value GROUP BY law, position),
delta AS (
  SELECT m.law, m.position, max(abs(m.mean - l.mean)) / abs(l.mean) AS delta
  FROM value AS m JOIN lot AS l USING (law, position) GROUP BY m.law, m.position),
beta AS (SELECT law, avg(delta) AS beta FROM delta GROUP BY law),
fits AS (
  SELECT f.law, json_group_object(d.name, json_object('mean', f.mean, 'std', f.std, 'best', f.best, 'runs', f.n,
    'percent', 100 * (f.mean / l.mean - 1))) AS json
  FROM fit_std AS f JOIN law_mean AS l USING (law) JOIN device AS d ON d.id = f.device GROUP BY f.law),
per_parameter AS (
  SELECT m.law, m.name, l.mean AS lot, json_group_object(d.name, json_object('mean', m.mean, 'std', m.std,
    'percent', 100 * (m.mean / l.mean - 1))) AS json
  FROM value_std AS m JOIN lot AS l USING (law, position) JOIN device AS d ON d.id = m.device GROUP BY m.law, m.position),
parameters AS (
  SELECT law, json_group_object(name, json_object('lot', lot, 'devices', json(json))) AS json FROM per_parameter GROUP BY law)
SELECT json_group_object(b.law, json_object('mean', m.mean, 'beta', b.beta, 'devices', json(f.json), 'parameters', json(p.json),
  'on_front', NOT EXISTS (
    SELECT 1 FROM beta AS other JOIN law_mean AS o USING (law)
    WHERE other.beta <= b.beta AND o.mean <= m.mean AND (other.beta < b.beta OR o.mean < m.mean))))
FROM beta AS b JOIN law_mean AS m USING (law) JOIN fits AS f USING (law) JOIN parameters AS p USING (law)
)sql";

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: expected_numbers STORE\n");
    return 2;
  }
  sqlite3* store = nullptr;
  sqlite3_stmt* statement = nullptr;
  bool const answered = sqlite3_open_v2(argv[1], &store, SQLITE_OPEN_READONLY, nullptr) == SQLITE_OK &&
                        sqlite3_prepare_v2(store, question, -1, &statement, nullptr) == SQLITE_OK &&
                        sqlite3_step(statement) == SQLITE_ROW;
  if (answered) {
    std::printf("%s\n", static_cast<char const*>(static_cast<void const*>(sqlite3_column_text(statement, 0))));
  } else {
    std::fprintf(stderr, "%s: %s\n", argv[1], sqlite3_errmsg(store));
  }
  sqlite3_finalize(statement);
  sqlite3_close(store);
  return answered ? 0 : 2;
}
