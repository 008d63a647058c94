PRAGMA foreign_keys=OFF;
BEGIN TRANSACTION;
CREATE TABLE scenario(
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL,
  text TEXT NOT NULL UNIQUE
) STRICT;
INSERT INTO scenario VALUES(1,'One lathe',replace('{\n  "$schema": "../scenario.schema.json",\n  "name": "One lathe",\n  "description": "One lathe turns shafts of 80 mm in three cuts. Nothing fails, nobody is needed, the edge never wears.",\n  "currency": "UAH",\n  "simulation": {\n    "horizon_min": 120000,\n    "warmup_min": 10000,\n    "replications": 10,\n    "seed": "1"\n  },\n  "machines": [\n    {\n      "name": "lathe",\n      "count": 1,\n      "rate_per_min": 4,\n      "limits": {\n        "power_kw": 4,\n        "spindle_speed_max_rpm": 2000,\n        "torque_max_nm": 200,\n        "feed_force_max_n": 4000\n      },\n      "loading": {\n        "kind": "constant",\n        "value_min": 0.5\n      }\n    }\n  ],\n  "operations": [\n    {\n      "name": "turn",\n      "machine": "lathe",\n      "process": {\n        "kind": "turning",\n        "diameter_mm": 80,\n        "length_mm": 300,\n        "passes": 3,\n        "cutting_speed_m_min": 120,\n        "feed_mm_rev": 0.33,\n        "depth_of_cut_mm": 1,\n        "material": {\n          "kc11_n_mm2": 2000,\n          "mc": 0.25,\n          "tensile_strength_mpa": 750\n        },\n        "insert": {\n          "nose_radius_mm": 2,\n          "kr_deg": 45,\n          "kr1_deg": 45\n        },\n        "heat": {\n          "flank_wear_mm": 0.1,\n          "tool_conductivity_w_mk": 27,\n          "tool_diffusivity_mm2_s": 11\n        },\n        "force_max_n": 1500,\n        "roughness_max_um": 3.2,\n        "temperature_max_c": 1200\n      }\n    }\n  ],\n  "stores": [\n    {\n      "name": "finished shafts"\n    }\n  ],\n  "parts": [\n    {\n      "name": "shaft",\n      "supply": {\n        "kind": "always_available"\n      },\n      "route": [\n        "turn"\n      ],\n      "value": 120,\n      "store": "finished shafts"\n    }\n  ]\n}\n','\n',char(10)));
INSERT INTO scenario VALUES(2,'When to index',replace('{\n  "$schema": "../scenario.schema.json",\n  "name": "When to index",\n  "description": "Step 4, and edges are changed in time: at the age that a share gamma of them survives.",\n  "currency": "UAH",\n  "simulation": {\n    "horizon_min": 120000,\n    "warmup_min": 10000,\n    "replications": 10,\n    "seed": "1"\n  },\n  "inserts": [\n    {\n      "name": "T15K6",\n      "grade": "P10",\n      "edges": 4,\n      "price": 60,\n      "edge_life": {\n        "law": "weibull",\n        "cv": 0.7,\n        "mean_ref_min": 45,\n        "cutting_speed_ref_m_min": 120,\n        "feed_ref_mm_rev": 0.3,\n        "depth_of_cut_ref_mm": 1,\n        "speed_exponent": 5,\n        "feed_exponent": 0.45,\n        "depth_exponent": 0.15\n      },\n      "provenance": "Plausible for steel 45; step 10 replaces it by what a log says."\n    }\n  ],\n  "tools": [\n    {\n      "name": "turning tool",\n      "insert": "T15K6",\n      "strategy": {\n        "kind": "age",\n        "gamma": 0.7\n      },\n      "crew": "setter",\n      "change": {\n        "index": {\n          "kind": "constant",\n          "value_min": 1.5\n        },\n        "replace": {\n          "kind": "constant",\n          "value_min": 2\n        },\n        "positioning_min": 1,\n        "failure_extra_min": 6\n      },\n      "insert_booking": "at_fitting",\n      "failure_damage": 120,\n      "failure_scrap_probability": 0.3\n    }\n  ],\n  "crews": [\n    {\n      "name": "fitter",\n      "members": 1,\n      "rate_per_min": 1.0\n    },\n    {\n      "name": "setter",\n      "members": 1,\n      "rate_per_min": 0.8\n    }\n  ],\n  "machines": [\n    {\n      "name": "lathe",\n      "count": 1,\n      "rate_per_min": 4,\n      "limits": {\n        "power_kw": 4,\n        "spindle_speed_max_rpm": 2000,\n        "torque_max_nm": 200,\n        "feed_force_max_n": 4000\n      },\n      "loading": {\n        "kind": "constant",\n        "value_min": 0.5\n      },\n      "failures": [\n        {\n          "name": "electrics",\n          "clock": "calendar",\n          "time_to_failure": {\n            "kind": "exponential",\n            "rate_per_min": 0.0004\n          },\n          "repair": {\n            "kind": "lognormal",\n            "mean_min": 120,\n            "cv": 0.8\n          },\n          "crew": "fitter"\n        },\n        {\n          "name": "spindle drive",\n          "clock": "operating",\n          "time_to_failure": {\n            "kind": "weibull",\n            "mean_min": 9000,\n            "cv": 0.5\n          },\n          "repair": {\n            "kind": "lognormal",\n            "mean_min": 400,\n            "cv": 0.5\n          },\n          "crew": "fitter"\n        }\n      ]\n    },\n    {\n      "name": "grinder",\n      "count": 1,\n      "rate_per_min": 4,\n      "limits": {\n        "power_kw": 11,\n        "spindle_speed_max_rpm": 2000\n      },\n      "loading": {\n        "kind": "constant",\n        "value_min": 4\n      },\n      "failures": [\n        {\n          "name": "wheel head",\n          "clock": "operating",\n          "time_to_failure": {\n            "kind": "exponential",\n            "rate_per_min": 0.0005\n          },\n          "repair": {\n            "kind": "lognormal",\n            "mean_min": 100,\n            "cv": 0.8\n          },\n          "crew": "fitter"\n        }\n      ],\n      "queue_capacity": 20\n    }\n  ],\n  "operations": [\n    {\n      "name": "turn",\n      "machine": "lathe",\n      "tool": "turning tool",\n      "process": {\n        "kind": "turning",\n        "diameter_mm": 80,\n        "length_mm": 300,\n        "passes": 3,\n        "cutting_speed_m_min": 120,\n        "feed_mm_rev": 0.33,\n        "depth_of_cut_mm": 1,\n        "material": {\n          "kc11_n_mm2": 2000,\n          "mc": 0.25,\n          "tensile_strength_mpa": 750\n        },\n        "insert": {\n          "nose_radius_mm": 2,\n          "kr_deg": 45,\n          "kr1_deg": 45\n        },\n        "heat": {\n          "flank_wear_mm": 0.1,\n          "tool_conductivity_w_mk": 27,\n          "tool_diffusivity_mm2_s": 11\n        },\n        "force_max_n": 1500,\n        "roughness_max_um": 3.2,\n        "temperature_max_c": 1200\n      }\n    },\n    {\n      "name": "grind",\n      "machine": "grinder",\n      "process": {\n        "kind": "cylindrical_grinding",\n        "diameter_mm": 60,\n        "length_mm": 120,\n        "allowance_um": 250,\n        "transform_c": 727,\n        "conductivity_w_mk": 30,\n        "diffusivity_m2_s": 8e-06,\n        "work_speed_m_min": 20,\n        "rough_infeed_um": 12,\n        "finish_infeed_um": 4,\n        "finish_allowance_um": 40,\n        "sparkout_passes": 3,\n        "traverse_feed_mm_rev": 20,\n        "overrun_mm": 20,\n        "specific_energy_j_mm3": 45,\n        "heat_fraction": 0.7,\n        "wheel_diameter_mm": 400,\n        "wheel_width_mm": 40,\n        "wheel_speed_m_s": 35,\n        "grinding_ratio": 40,\n        "grain_protrusion_um": 30,\n        "protrusion_loss_um_min": 0.2,\n        "roughness_ra_max_um": 0.8,\n        "defect_depth_max_um": 0\n      }\n    }\n  ],\n  "stores": [\n    {\n      "name": "finished shafts"\n    }\n  ],\n  "parts": [\n    {\n      "name": "shaft",\n      "supply": {\n        "kind": "always_available"\n      },\n      "route": [\n        "turn",\n        "grind"\n      ],\n      "value": 120,\n      "store": "finished shafts",\n      "release": {\n        "kind": "conwip",\n        "cap": 40\n      }\n    }\n  ]\n}\n','\n',char(10)));
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
INSERT INTO run VALUES(1,'run','UAH',1,'[{"pointer":"/simulation/horizon_min","value":3000},{"pointer":"/simulation/warmup_min","value":100},{"pointer":"/simulation/replications","value":2}]','1',2,3000.0,100.0,0.011566237999999999519,'0.1.0','x86-64 with FMA, glibc 2.36','2026-11-23T01:23:51Z');
CREATE TABLE kpi(
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL,
  unit TEXT NOT NULL,
  meaning TEXT NOT NULL,
  UNIQUE(name, unit, meaning)
) STRICT;
INSERT INTO kpi VALUES(1,'cost_per_part','UAH','all costs / parts finished, good or scrapped');
INSERT INTO kpi VALUES(2,'cost_per_good_part','UAH','all costs / good parts');
INSERT INTO kpi VALUES(3,'throughput_per_h','parts/h','good parts per hour of calendar time');
INSERT INTO kpi VALUES(4,'parts_good','parts','good parts in the counted time');
INSERT INTO kpi VALUES(5,'parts_scrapped','parts','scrapped parts in the counted time');
INSERT INTO kpi VALUES(6,'quality_ratio','1','good parts / parts finished (ISO 22400)');
INSERT INTO kpi VALUES(7,'work_in_process','parts','mean number of parts in the shop');
INSERT INTO kpi VALUES(8,'lead_time_min','min','mean time from the start or arrival of a part to its end');
INSERT INTO kpi VALUES(9,'lead_time_p50_min','min','median of the lead times of batches');
INSERT INTO kpi VALUES(10,'lead_time_p90_min','min','90 % of the batches take no longer');
INSERT INTO kpi VALUES(11,'lead_time/release_min','min','mean part of the lead time spent waiting to be let into the shop');
INSERT INTO kpi VALUES(12,'lead_time/components_min','min','mean part of the lead time spent waiting for parts to assemble');
INSERT INTO kpi VALUES(13,'lead_time/queue_min','min','mean part of the lead time spent waiting for a machine');
INSERT INTO kpi VALUES(14,'lead_time/machine_min','min','mean part of the lead time spent on a machine: set-up, loading, work and stops');
INSERT INTO kpi VALUES(15,'lead_time/blocked_min','min','mean part of the lead time spent waiting for room at the next place');
INSERT INTO kpi VALUES(16,'lead_time/transport_min','min','mean part of the lead time spent under way');
INSERT INTO kpi VALUES(17,'cost/machining','UAH/part','machine minutes of cutting, per part finished');
INSERT INTO kpi VALUES(18,'cost/other_operations','UAH/part','machine minutes of operations given as durations, per part finished');
INSERT INTO kpi VALUES(19,'cost/loading','UAH/part','machine minutes of loading and unloading, per part finished');
INSERT INTO kpi VALUES(20,'cost/idle','UAH/part','machine minutes without a part, per part finished');
INSERT INTO kpi VALUES(21,'cost/labour','UAH/part','crews paid by the shift, and attendance of machines, per part finished');
INSERT INTO kpi VALUES(22,'cost/inserts','UAH/part','inserts, per part finished');
INSERT INTO kpi VALUES(23,'cost/regrinding','UAH/part','regrinding, per part finished');
INSERT INTO kpi VALUES(24,'cost/damage','UAH/part','holders, shims, rework and damage after failures, per part finished');
INSERT INTO kpi VALUES(25,'cost/scrap','UAH/part','value of scrapped parts, per part finished');
INSERT INTO kpi VALUES(26,'machine/lathe/availability','1','actual production time / planned busy time (ISO 22400)');
INSERT INTO kpi VALUES(27,'machine/lathe/effectiveness','1','planned main time of the parts made / actual production time (ISO 22400)');
INSERT INTO kpi VALUES(28,'machine/lathe/quality_ratio','1','parts not rejected at the machine / parts made (ISO 22400)');
INSERT INTO kpi VALUES(29,'machine/lathe/oee','1','availability x effectiveness x quality ratio = value-adding share of the planned busy time');
INSERT INTO kpi VALUES(30,'machine/lathe/utilization','1','active time / time inside the calendar');
INSERT INTO kpi VALUES(31,'machine/lathe/active_period_min','min','mean uninterrupted active period; the longest in the shop marks the bottleneck (Roser 2001)');
INSERT INTO kpi VALUES(32,'machine/lathe/loss/breakdowns','1','share of the planned busy time: repairs, changes after a failure, waiting for them');
INSERT INTO kpi VALUES(33,'machine/lathe/loss/setup','1','share of the planned busy time: set-ups (and planned changes, as the scenario says)');
INSERT INTO kpi VALUES(34,'machine/lathe/loss/stops','1','share of the planned busy time: idling, blocking, waiting, loading, planned changes');
INSERT INTO kpi VALUES(35,'machine/lathe/loss/speed','1','share of the planned busy time: production slower than planned');
INSERT INTO kpi VALUES(36,'machine/lathe/loss/rejects','1','share of the planned busy time: spent on parts that were rejected');
INSERT INTO kpi VALUES(37,'machine/lathe/loss/start_up','1','share of the planned busy time: warming up');
INSERT INTO kpi VALUES(38,'machine/lathe/state/cutting','1','share of the time spent cutting');
INSERT INTO kpi VALUES(39,'machine/lathe/state/working','1','share of the time spent on operations given as durations');
INSERT INTO kpi VALUES(40,'machine/lathe/state/loading','1','share of the time spent loading and unloading');
INSERT INTO kpi VALUES(41,'machine/lathe/state/idle','1','share of the time without a part to work on');
INSERT INTO kpi VALUES(42,'queue/lathe/mean_length','batches','mean number of batches that wait before the machine group');
INSERT INTO kpi VALUES(43,'limits/lathe/starved_by/(supply)','1','share of the group''s time idle until a batch came from there');
INSERT INTO kpi VALUES(44,'part/shaft/good','parts','good parts in the counted time');
INSERT INTO kpi VALUES(45,'part/shaft/scrapped','parts','scrapped parts in the counted time');
INSERT INTO kpi VALUES(46,'part/shaft/throughput_per_h','parts/h','good parts per hour of calendar time');
INSERT INTO kpi VALUES(47,'part/shaft/lead_time_min','min','mean time from the start or arrival of a part to its end');
CREATE TABLE run_kpi(
  run_id INTEGER NOT NULL REFERENCES run(id),
  position INTEGER NOT NULL,
  kpi_id INTEGER NOT NULL REFERENCES kpi(id),
  mean REAL CHECK(mean IS NULL OR abs(mean) < 9e999),
  half_width REAL CHECK(half_width IS NULL OR abs(half_width) < 9e999),
  samples INTEGER NOT NULL,
  PRIMARY KEY(run_id, position)
) STRICT, WITHOUT ROWID;
INSERT INTO run_kpi VALUES(1,0,1,24.892703862660944479,0.0,2);
INSERT INTO run_kpi VALUES(1,1,2,24.892703862660944479,0.0,2);
INSERT INTO run_kpi VALUES(1,2,3,9.6413793103448277577,0.0,2);
INSERT INTO run_kpi VALUES(1,3,4,466.0,0.0,2);
INSERT INTO run_kpi VALUES(1,4,5,0.0,0.0,2);
INSERT INTO run_kpi VALUES(1,5,6,1.0,0.0,2);
INSERT INTO run_kpi VALUES(1,6,7,1.0,0.0,2);
INSERT INTO run_kpi VALUES(1,7,8,6.2119866428905563537,0.0,2);
INSERT INTO run_kpi VALUES(1,8,9,6.2119866428905563537,0.0,2);
INSERT INTO run_kpi VALUES(1,9,10,6.2119866428906789224,0.0,2);
INSERT INTO run_kpi VALUES(1,10,11,0.0,0.0,2);
INSERT INTO run_kpi VALUES(1,11,12,0.0,0.0,2);
INSERT INTO run_kpi VALUES(1,12,13,0.0,0.0,2);
INSERT INTO run_kpi VALUES(1,13,14,6.2119866428905563537,0.0,2);
INSERT INTO run_kpi VALUES(1,14,15,0.0,0.0,2);
INSERT INTO run_kpi VALUES(1,15,16,0.0,0.0,2);
INSERT INTO run_kpi VALUES(1,16,17,0.0,0.0,2);
INSERT INTO run_kpi VALUES(1,17,18,22.892703862660944481,0.0,2);
INSERT INTO run_kpi VALUES(1,18,19,2.0,0.0,2);
INSERT INTO run_kpi VALUES(1,19,20,0.0,0.0,2);
INSERT INTO run_kpi VALUES(1,20,21,0.0,0.0,2);
INSERT INTO run_kpi VALUES(1,21,22,0.0,0.0,2);
INSERT INTO run_kpi VALUES(1,22,23,0.0,0.0,2);
INSERT INTO run_kpi VALUES(1,23,24,0.0,0.0,2);
INSERT INTO run_kpi VALUES(1,24,25,0.0,0.0,2);
INSERT INTO run_kpi VALUES(1,25,26,0.91965517241379313162,0.0,2);
INSERT INTO run_kpi VALUES(1,26,27,0.9980449102313427856,0.0,2);
INSERT INTO run_kpi VALUES(1,27,28,1.0,0.0,2);
INSERT INTO run_kpi VALUES(1,28,29,0.91785716399551431354,0.0,2);
INSERT INTO run_kpi VALUES(1,29,30,1.0,0.0,2);
INSERT INTO run_kpi VALUES(1,30,31,2900.0,0.0,2);
INSERT INTO run_kpi VALUES(1,31,32,0.0,0.0,2);
INSERT INTO run_kpi VALUES(1,32,33,0.0,0.0,2);
INSERT INTO run_kpi VALUES(1,33,34,0.08034482758620689613,0.0,2);
INSERT INTO run_kpi VALUES(1,34,35,0.0017980084182788451819,0.0,2);
INSERT INTO run_kpi VALUES(1,35,36,0.0,0.0,2);
INSERT INTO run_kpi VALUES(1,36,37,0.0,0.0,2);
INSERT INTO run_kpi VALUES(1,37,38,0.0,0.0,2);
INSERT INTO run_kpi VALUES(1,38,39,0.91965517241379313162,0.0,2);
INSERT INTO run_kpi VALUES(1,39,40,0.08034482758620689613,0.0,2);
INSERT INTO run_kpi VALUES(1,40,41,0.0,0.0,2);
INSERT INTO run_kpi VALUES(1,41,42,0.0,0.0,2);
INSERT INTO run_kpi VALUES(1,42,43,0.0,0.0,2);
INSERT INTO run_kpi VALUES(1,43,44,466.0,0.0,2);
INSERT INTO run_kpi VALUES(1,44,45,0.0,0.0,2);
INSERT INTO run_kpi VALUES(1,45,46,9.6413793103448277577,0.0,2);
INSERT INTO run_kpi VALUES(1,46,47,6.2119866428905563537,0.0,2);
CREATE TABLE replication_kpi(
  run_id INTEGER NOT NULL REFERENCES run(id),
  replication INTEGER NOT NULL,
  position INTEGER NOT NULL,
  value REAL NOT NULL CHECK(abs(value) < 9e999),
  PRIMARY KEY(run_id, replication, position)
) STRICT, WITHOUT ROWID;
INSERT INTO replication_kpi VALUES(1,0,0,24.892703862660944479);
INSERT INTO replication_kpi VALUES(1,0,1,24.892703862660944479);
INSERT INTO replication_kpi VALUES(1,0,2,9.6413793103448277577);
INSERT INTO replication_kpi VALUES(1,0,3,466.0);
INSERT INTO replication_kpi VALUES(1,0,4,0.0);
INSERT INTO replication_kpi VALUES(1,0,5,1.0);
INSERT INTO replication_kpi VALUES(1,0,6,1.0);
INSERT INTO replication_kpi VALUES(1,0,7,6.2119866428905563537);
INSERT INTO replication_kpi VALUES(1,0,8,6.2119866428905563537);
INSERT INTO replication_kpi VALUES(1,0,9,6.2119866428906789224);
INSERT INTO replication_kpi VALUES(1,0,10,0.0);
INSERT INTO replication_kpi VALUES(1,0,11,0.0);
INSERT INTO replication_kpi VALUES(1,0,12,0.0);
INSERT INTO replication_kpi VALUES(1,0,13,6.2119866428905563537);
INSERT INTO replication_kpi VALUES(1,0,14,0.0);
INSERT INTO replication_kpi VALUES(1,0,15,0.0);
INSERT INTO replication_kpi VALUES(1,0,16,0.0);
INSERT INTO replication_kpi VALUES(1,0,17,22.892703862660944481);
INSERT INTO replication_kpi VALUES(1,0,18,2.0);
INSERT INTO replication_kpi VALUES(1,0,19,0.0);
INSERT INTO replication_kpi VALUES(1,0,20,0.0);
INSERT INTO replication_kpi VALUES(1,0,21,0.0);
INSERT INTO replication_kpi VALUES(1,0,22,0.0);
INSERT INTO replication_kpi VALUES(1,0,23,0.0);
INSERT INTO replication_kpi VALUES(1,0,24,0.0);
INSERT INTO replication_kpi VALUES(1,0,25,0.91965517241379313162);
INSERT INTO replication_kpi VALUES(1,0,26,0.9980449102313427856);
INSERT INTO replication_kpi VALUES(1,0,27,1.0);
INSERT INTO replication_kpi VALUES(1,0,28,0.91785716399551431354);
INSERT INTO replication_kpi VALUES(1,0,29,1.0);
INSERT INTO replication_kpi VALUES(1,0,30,2900.0);
INSERT INTO replication_kpi VALUES(1,0,31,0.0);
INSERT INTO replication_kpi VALUES(1,0,32,0.0);
INSERT INTO replication_kpi VALUES(1,0,33,0.08034482758620689613);
INSERT INTO replication_kpi VALUES(1,0,34,0.0017980084182788451819);
INSERT INTO replication_kpi VALUES(1,0,35,0.0);
INSERT INTO replication_kpi VALUES(1,0,36,0.0);
INSERT INTO replication_kpi VALUES(1,0,37,0.0);
INSERT INTO replication_kpi VALUES(1,0,38,0.91965517241379313162);
INSERT INTO replication_kpi VALUES(1,0,39,0.08034482758620689613);
INSERT INTO replication_kpi VALUES(1,0,40,0.0);
INSERT INTO replication_kpi VALUES(1,0,41,0.0);
INSERT INTO replication_kpi VALUES(1,0,42,0.0);
INSERT INTO replication_kpi VALUES(1,0,43,466.0);
INSERT INTO replication_kpi VALUES(1,0,44,0.0);
INSERT INTO replication_kpi VALUES(1,0,45,9.6413793103448277577);
INSERT INTO replication_kpi VALUES(1,0,46,6.2119866428905563537);
INSERT INTO replication_kpi VALUES(1,1,0,24.892703862660944479);
INSERT INTO replication_kpi VALUES(1,1,1,24.892703862660944479);
INSERT INTO replication_kpi VALUES(1,1,2,9.6413793103448277577);
INSERT INTO replication_kpi VALUES(1,1,3,466.0);
INSERT INTO replication_kpi VALUES(1,1,4,0.0);
INSERT INTO replication_kpi VALUES(1,1,5,1.0);
INSERT INTO replication_kpi VALUES(1,1,6,1.0);
INSERT INTO replication_kpi VALUES(1,1,7,6.2119866428905563537);
INSERT INTO replication_kpi VALUES(1,1,8,6.2119866428905563537);
INSERT INTO replication_kpi VALUES(1,1,9,6.2119866428906789224);
INSERT INTO replication_kpi VALUES(1,1,10,0.0);
INSERT INTO replication_kpi VALUES(1,1,11,0.0);
INSERT INTO replication_kpi VALUES(1,1,12,0.0);
INSERT INTO replication_kpi VALUES(1,1,13,6.2119866428905563537);
INSERT INTO replication_kpi VALUES(1,1,14,0.0);
INSERT INTO replication_kpi VALUES(1,1,15,0.0);
INSERT INTO replication_kpi VALUES(1,1,16,0.0);
INSERT INTO replication_kpi VALUES(1,1,17,22.892703862660944481);
INSERT INTO replication_kpi VALUES(1,1,18,2.0);
INSERT INTO replication_kpi VALUES(1,1,19,0.0);
INSERT INTO replication_kpi VALUES(1,1,20,0.0);
INSERT INTO replication_kpi VALUES(1,1,21,0.0);
INSERT INTO replication_kpi VALUES(1,1,22,0.0);
INSERT INTO replication_kpi VALUES(1,1,23,0.0);
INSERT INTO replication_kpi VALUES(1,1,24,0.0);
INSERT INTO replication_kpi VALUES(1,1,25,0.91965517241379313162);
INSERT INTO replication_kpi VALUES(1,1,26,0.9980449102313427856);
INSERT INTO replication_kpi VALUES(1,1,27,1.0);
INSERT INTO replication_kpi VALUES(1,1,28,0.91785716399551431354);
INSERT INTO replication_kpi VALUES(1,1,29,1.0);
INSERT INTO replication_kpi VALUES(1,1,30,2900.0);
INSERT INTO replication_kpi VALUES(1,1,31,0.0);
INSERT INTO replication_kpi VALUES(1,1,32,0.0);
INSERT INTO replication_kpi VALUES(1,1,33,0.08034482758620689613);
INSERT INTO replication_kpi VALUES(1,1,34,0.0017980084182788451819);
INSERT INTO replication_kpi VALUES(1,1,35,0.0);
INSERT INTO replication_kpi VALUES(1,1,36,0.0);
INSERT INTO replication_kpi VALUES(1,1,37,0.0);
INSERT INTO replication_kpi VALUES(1,1,38,0.91965517241379313162);
INSERT INTO replication_kpi VALUES(1,1,39,0.08034482758620689613);
INSERT INTO replication_kpi VALUES(1,1,40,0.0);
INSERT INTO replication_kpi VALUES(1,1,41,0.0);
INSERT INTO replication_kpi VALUES(1,1,42,0.0);
INSERT INTO replication_kpi VALUES(1,1,43,466.0);
INSERT INTO replication_kpi VALUES(1,1,44,0.0);
INSERT INTO replication_kpi VALUES(1,1,45,9.6413793103448277577);
INSERT INTO replication_kpi VALUES(1,1,46,6.2119866428905563537);
CREATE TABLE study_variable(
  study_id INTEGER NOT NULL REFERENCES study(id),
  position INTEGER NOT NULL,
  name TEXT NOT NULL,
  pointer TEXT NOT NULL,
  unit TEXT NOT NULL,
  low REAL NOT NULL CHECK(abs(low) < 9e999),
  high REAL NOT NULL CHECK(abs(high) < 9e999), type TEXT NOT NULL DEFAULT 'continuous'
  CHECK(type IN ('continuous', 'integer', 'categorical')), options TEXT NOT NULL DEFAULT '[]',
  PRIMARY KEY(study_id, position)
) STRICT, WITHOUT ROWID;
INSERT INTO study_variable VALUES(1,0,'/tools/0/strategy/gamma','/tools/0/strategy/gamma','1',0.4000000000000000222,0.8000000000000000444,'continuous','[]');
CREATE TABLE trial(
  study_id INTEGER NOT NULL REFERENCES study(id),
  number INTEGER NOT NULL,
  stage TEXT NOT NULL,
  variables BLOB NOT NULL,
  objective REAL CHECK(objective IS NULL OR abs(objective) < 9e999),
  feasible INTEGER NOT NULL CHECK(feasible IN (0, 1)), half_width REAL CHECK(half_width IS NULL OR abs(half_width) < 9e999), first_replication INTEGER NOT NULL DEFAULT 0, replications INTEGER NOT NULL DEFAULT 0, outcome BLOB NOT NULL DEFAULT x'',
  PRIMARY KEY(study_id, number)
) STRICT, WITHOUT ROWID;
INSERT INTO trial VALUES(1,1,'design',X'55b17219fa54efbf',88.703248758330317967,1,30.619475291388926763,0,2,X'41cab1453cc756405a3377c8c7925540a264d7264a761d407da9a0d5970a1e40');
INSERT INTO trial VALUES(1,2,'design',X'f86996a9c5fee93f',87.032410419632981303,1,15.460730107698175573,0,2,X'2eff6631337455409a30e7d4f20f5640970a5a7da9a01d40bdc590ce5b0c1d40');
INSERT INTO trial VALUES(1,3,'design',X'f043310426cfb33f',87.372812354412573657,1,42.717778632875081255,0,2,X'94864ec5b10055400259648b06af56406da264d7264a1e40bdc590ce5b0c1d40');
CREATE TABLE IF NOT EXISTS "study"(
  id INTEGER PRIMARY KEY,
  kind TEXT NOT NULL CHECK(kind IN ('optimize', 'sweep', 'compare', 'losses')),
  name TEXT NOT NULL,
  status TEXT NOT NULL CHECK(status IN ('running', 'finished', 'interrupted', 'failed')),
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
INSERT INTO study VALUES(1,'sweep','Sweep of When to index','finished','cost_per_part',2,'[{"pointer":"/simulation/horizon_min","value":3000},{"pointer":"/simulation/warmup_min","value":100},{"pointer":"/simulation/replications","value":2}]','{"factors":["/tools/0/strategy/gamma=0.4..0.8"],"design":"lhs","points":"3","kpis":["cost_per_part","throughput_per_h"]}','1','0.1.0','x86-64 with FMA, glibc 2.36','2026-11-23T01:23:51Z',NULL,NULL,'{"design":"lhs","replications":2,"factors":[{"pointer":"/tools/0/strategy/gamma","low":0.4,"high":0.8}],"points":[{"values":[0.40417536741196425],"cost_per_part":{"mean":88.70324875833032,"half_width_95":30.619475291388927},"throughput_per_h":{"mean":7.437931034482759,"half_width_95":0.9201044808954065}},{"values":[0.7624700224353204],"cost_per_part":{"mean":87.03241041963298,"half_width_95":15.460730107698176},"throughput_per_h":{"mean":7.334482758620689,"half_width_95":0.9201044808954036}},{"values":[0.6154759170577137],"cost_per_part":{"mean":87.37281235441257,"half_width_95":42.71777863287508},"throughput_per_h":{"mean":7.417241379310345,"half_width_95":1.9716524590615874}}],"kpis":[{"kpi":"cost_per_part","effects":[{"effect":"/tools/0/strategy/gamma","value":-1.9109289983055477,"half_width":57.54474039827142}]},{"kpi":"throughput_per_h","effects":[{"effect":"/tools/0/strategy/gamma","value":-0.11016114807858843,"half_width":2.2931594996233615}]}]}');
CREATE INDEX run_of_scenario ON run(scenario_id);
CREATE UNIQUE INDEX trial_once ON trial(study_id, stage, variables, first_replication, replications)
  WHERE length(outcome) > 0;
PRAGMA user_version = 2;
COMMIT;
