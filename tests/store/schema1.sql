PRAGMA foreign_keys=OFF;
BEGIN TRANSACTION;
CREATE TABLE scenario(
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL,
  text TEXT NOT NULL UNIQUE
) STRICT;
INSERT INTO scenario VALUES(1,'Heavy-lathe cell',replace('{\n  "$schema": "../scenario.schema.json",\n  "name": "Heavy-lathe cell",\n  "description": "Two heavy CNC lathes turn steel shafts with assembled carbide tools; one setter indexes and changes the inserts. The cell of card K117: only the life law (Weibull, CV 0.7), the restoration rate 0.3 1/min and the reliability levels are printed in the paper, every other number is the card''s default set, plausible for a heavy lathe about 2010.",\n  "currency": "UAH",\n  "simulation": {"horizon_min": 250000, "warmup_min": 10000, "replications": 20, "seed": "20111"},\n  "inserts": [\n    {\n      "name": "T5K10",\n      "grade": "T5K10 (P30), indexable, untreated",\n      "edges": 2,\n      "price": 80,\n      "edge_life": {\n        "law": "weibull",\n        "cv": 0.7,\n        "mean_ref_min": 60,\n        "cutting_speed_ref_m_min": 60,\n        "feed_ref_mm_rev": 1.0,\n        "depth_of_cut_ref_mm": 10,\n        "speed_exponent": 5,\n        "feed_exponent": 0.45,\n        "depth_exponent": 0.15\n      },\n      "reserve_ok_probability": 1,\n      "single_edge_probability": 0,\n      "provenance": "Law and CV: Andronov 2011 (K117). Mean life, exponents, price: default set of card K117 (completion)."\n    }\n  ],\n  "tools": [\n    {\n      "name": "roughing tool",\n      "insert": "T5K10",\n      "strategy": {"kind": "age", "gamma": 0.64},\n      "crew": "setter",\n      "change": {\n        "index": {"kind": "exponential", "rate_per_min": 0.3},\n        "replace": {"kind": "exponential", "rate_per_min": 0.3},\n        "positioning_min": 1.6666666666666667,\n        "failure_extra_min": 10\n      },\n      "insert_booking": "life_periods",\n      "periods_planned": 4,\n      "periods_failure": 2,\n      "regrind_planned": 0,\n      "regrind_failure": 0,\n      "failure_damage": 52,\n      "failure_scrap_probability": 0.02\n    }\n  ],\n  "crews": [{"name": "setter", "members": 1, "rate_per_min": 0.5, "pay": "busy"}],\n  "machines": [{"name": "lathe", "model": "16274F3", "count": 2, "rate_per_min": 3.0}],\n  "operations": [\n    {\n      "name": "rough turning",\n      "machine": "lathe",\n      "tool": "roughing tool",\n      "process": {\n        "kind": "turning",\n        "diameter_mm": 500,\n        "length_mm": 1000,\n        "passes": 1,\n        "cutting_speed_m_min": 60,\n        "feed_mm_rev": 1.0,\n        "depth_of_cut_mm": 10\n      }\n    }\n  ],\n  "stores": [{"name": "finished shafts"}],\n  "parts": [\n    {\n      "name": "shaft",\n      "supply": {"kind": "always_available"},\n      "route": ["rough turning"],\n      "value": 1000,\n      "store": "finished shafts"\n    }\n  ]\n}\n','\n',char(10)));
CREATE TABLE run(
  id INTEGER PRIMARY KEY,
  label TEXT NOT NULL,
  -- of the run, not of the scenario text: a change may set it
  currency TEXT NOT NULL,
  scenario_id INTEGER NOT NULL REFERENCES scenario(id),
  changes TEXT NOT NULL,
  seed TEXT NOT NULL,
  replications INTEGER NOT NULL CHECK(replications > 0),
  horizon_min REAL NOT NULL CHECK(abs(horizon_min) < 9e999),
  warmup_min REAL NOT NULL CHECK(abs(warmup_min) < 9e999),
  elapsed_s REAL NOT NULL CHECK(abs(elapsed_s) < 9e999),
  version TEXT NOT NULL,
  platform TEXT NOT NULL,
  created TEXT NOT NULL
) STRICT;
INSERT INTO run VALUES(1,'study 1: today','UAH',1,'[{"pointer":"/simulation/horizon_min","value":12000},{"pointer":"/simulation/replications","value":2},{"pointer":"/simulation/replications","value":2}]','20111',2,12000.0,10000.0,0.0026925765000000000809,'0.1.0','x86-64 with FMA, glibc 2.36','2026-11-22T19:24:37Z');
INSERT INTO run VALUES(2,'study 1: best','UAH',1,'[{"pointer":"/simulation/horizon_min","value":12000},{"pointer":"/simulation/replications","value":2},{"pointer":"/tools/0/strategy/gamma","value":0.64},{"pointer":"/operations/0/process/cutting_speed_m_min","value":60.0},{"pointer":"/simulation/replications","value":2}]','20111',2,12000.0,10000.0,0.0026925765000000000809,'0.1.0','x86-64 with FMA, glibc 2.36','2026-11-22T19:24:37Z');
CREATE TABLE kpi(
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL,
  unit TEXT NOT NULL,
  meaning TEXT NOT NULL,
  UNIQUE(name, unit, meaning)
) STRICT;
CREATE TABLE run_kpi(
  run_id INTEGER NOT NULL REFERENCES run(id),
  position INTEGER NOT NULL,
  kpi_id INTEGER NOT NULL REFERENCES kpi(id),
  mean REAL CHECK(mean IS NULL OR abs(mean) < 9e999),
  half_width REAL CHECK(half_width IS NULL OR abs(half_width) < 9e999),
  samples INTEGER NOT NULL,
  PRIMARY KEY(run_id, position)
) STRICT, WITHOUT ROWID;
CREATE TABLE replication_kpi(
  run_id INTEGER NOT NULL REFERENCES run(id),
  replication INTEGER NOT NULL,
  position INTEGER NOT NULL,
  value REAL NOT NULL CHECK(abs(value) < 9e999),
  PRIMARY KEY(run_id, replication, position)
) STRICT, WITHOUT ROWID;
CREATE TABLE study(
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL,
  status TEXT NOT NULL CHECK(status IN ('running', 'finished', 'failed')),
  objective TEXT NOT NULL,
  scenario_id INTEGER NOT NULL REFERENCES scenario(id),
  changes TEXT NOT NULL,
  study_text TEXT NOT NULL,
  seed TEXT NOT NULL,
  version TEXT NOT NULL,
  platform TEXT NOT NULL,
  created TEXT NOT NULL,
  baseline_run INTEGER REFERENCES run(id),
  best_run INTEGER REFERENCES run(id),
  result TEXT NOT NULL
) STRICT;
INSERT INTO study VALUES(1,'Reliability level and cutting speed of the heavy-lathe cell','finished','cost_per_part',1,'[{"pointer":"/simulation/horizon_min","value":12000},{"pointer":"/simulation/replications","value":2}]','{"name": "Reliability level and cutting speed of the heavy-lathe cell", "scenario": "heavy-lathe.json", "variables": [{"name": "reliability level gamma", "pointer": "/tools/0/strategy/gamma", "unit": "1", "low": 0.05, "high": 0.98}, {"name": "cutting speed", "pointer": "/operations/0/process/cutting_speed_m_min", "unit": "m/min", "low": 20, "high": 120}], "objective": {"kpi": "cost_per_part", "direction": "minimize"}, "search": {"max_evaluations": 6, "relative_precision": 1e-08}, "confirmation": {"replications": 40, "confidence": 0.95}}','20111','0.1.0','x86-64 with FMA, glibc 2.36','2026-11-22T19:24:37Z',1,2,'{"objective":"cost_per_part","unit":"UAH","baseline":{"values":[{"name":"reliability level gamma","pointer":"/tools/0/strategy/gamma","unit":"1","value":0.64},{"name":"cutting speed","pointer":"/operations/0/process/cutting_speed_m_min","unit":"m/min","value":60.0}],"analytic":146.79716106963926,"simulated":{"mean":149.76174308260912,"half_width_95":84.36258495806332}},"best":{"values":[{"name":"reliability level gamma","pointer":"/tools/0/strategy/gamma","unit":"1","value":0.64},{"name":"cutting speed","pointer":"/operations/0/process/cutting_speed_m_min","unit":"m/min","value":60.0}],"analytic":146.79716106963926,"simulated":{"mean":149.76174308260912,"half_width_95":84.36258495806332}},"evaluations":4,"saving":{"mean":0.0,"half_width":0.0,"confidence":0.95},"verdict":"not distinguishable","words":"The best plan and today''s cannot be told apart: 0.00 +- 0.00 % of the cost per part."}');
CREATE TABLE study_variable(
  study_id INTEGER NOT NULL REFERENCES study(id),
  position INTEGER NOT NULL,
  name TEXT NOT NULL,
  pointer TEXT NOT NULL,
  unit TEXT NOT NULL,
  low REAL NOT NULL CHECK(abs(low) < 9e999),
  high REAL NOT NULL CHECK(abs(high) < 9e999),
  PRIMARY KEY(study_id, position)
) STRICT, WITHOUT ROWID;
INSERT INTO study_variable VALUES(1,0,'reliability level gamma','/tools/0/strategy/gamma','1',0.050000000000000002775,0.97999999999999998223);
INSERT INTO study_variable VALUES(1,1,'cutting speed','/operations/0/process/cutting_speed_m_min','m/min',20.0,120.0);
CREATE TABLE trial(
  study_id INTEGER NOT NULL REFERENCES study(id),
  number INTEGER NOT NULL,
  stage TEXT NOT NULL,
  variables BLOB NOT NULL,
  objective REAL CHECK(objective IS NULL OR abs(objective) < 9e999),
  feasible INTEGER NOT NULL CHECK(feasible IN (0, 1)),
  PRIMARY KEY(study_id, number)
) STRICT, WITHOUT ROWID;
INSERT INTO trial VALUES(1,1,'analytic',X'7b14ae47e17ae03f0000000000805140',191.19913260077828453,1);
INSERT INTO trial VALUES(1,2,'analytic',X'7c14ae47e17ae03f0000000000805140',191.19913260077828453,1);
INSERT INTO trial VALUES(1,3,'analytic',X'7b14ae47e17ae43f0000000000004e40',146.79716106963925881,1);
INSERT INTO trial VALUES(1,4,'analytic',X'7b14ae47e17ae43f0000000000004e40',146.79716106963925881,1);
CREATE INDEX run_of_scenario ON run(scenario_id);
PRAGMA user_version = 1;
COMMIT;
