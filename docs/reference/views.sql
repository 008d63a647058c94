-- Temporary views over a Verstat results database: nothing is written into the file.

CREATE TEMP VIEW runs AS
SELECT run.id AS run, run.label, scenario.name AS shop, run.changes, run.seed, run.replications, run.horizon_min,
       run.warmup_min, run.currency, run.version, run.created
FROM main.run JOIN main.scenario ON scenario.id = run.scenario_id;

-- One row per run and KPI: the mean and the half-width of its 95 % interval.
CREATE TEMP VIEW kpis AS
SELECT run_kpi.run_id AS run, kpi.name AS kpi, run_kpi.mean, run_kpi.half_width, kpi.unit, run_kpi.samples, kpi.meaning
FROM main.run_kpi JOIN main.kpi ON kpi.id = run_kpi.kpi_id;

-- One row per run, replication and KPI, for intervals and plots of your own.
CREATE TEMP VIEW replications AS
SELECT value.run_id AS run, value.replication, kpi.name AS kpi, value.value, kpi.unit
FROM main.replication_kpi AS value
JOIN main.run_kpi ON run_kpi.run_id = value.run_id AND run_kpi.position = value.position
JOIN main.kpi ON kpi.id = run_kpi.kpi_id;

-- What a part costs, heading by heading; the headings add up to cost_per_part.
CREATE TEMP VIEW costs AS
SELECT run, substr(kpi, 6) AS heading, mean, half_width, unit FROM kpis WHERE kpi LIKE 'cost/%';

-- Inserts and edges of every tool.
CREATE TEMP VIEW edges AS
SELECT run, substr(kpi, 6, length(kpi) - 5 - length('/inserts_per_100_parts')) AS tool, mean AS inserts_per_100_parts, half_width
FROM kpis WHERE kpi LIKE 'tool/%/inserts_per_100_parts';

CREATE TEMP VIEW studies AS
SELECT study.id AS study, study.kind, study.name, study.status, study.baseline_run, study.best_run, study.created,
       (SELECT count(*) FROM main.trial WHERE trial.study_id = study.id) AS trials
FROM main.study;

CREATE TEMP VIEW trials AS
SELECT study_id AS study, number, stage, objective, half_width, replications, feasible FROM main.trial;
