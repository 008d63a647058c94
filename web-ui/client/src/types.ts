// What the server answers, member for member: see /api/v1/openapi.json.

export interface Provenance {
  version: string;
  platform: string;
  created: string;
}

export interface Change {
  pointer: string;
  value: unknown;
}

export interface Kpi {
  name: string;
  unit: string;
  meaning: string;
  mean: number | null;
  half_width_95: number | null;
  samples: number;
  values?: (number | null)[];
}

export interface RunHeader {
  id: number;
  label: string;
  scenario: string;
  changes: Change[] | string;
  seed: string;
  replications: number;
  horizon_min: number;
  warmup_min: number;
  elapsed_s: number;
  provenance: Provenance;
  /** Only in lists, and only when asked for with ?kpis=. */
  kpis?: Kpi[];
  currency?: string;
}

export interface Run extends RunHeader {
  currency: string;
  kpis: Kpi[];
}

export interface StudyHeader {
  id: number;
  name: string;
  scenario: string;
  status: string;
  objective: string;
  trials: number;
  seed: string;
  provenance: Provenance;
}

export interface Variable {
  name: string;
  pointer: string;
  unit: string;
  low: number;
  high: number;
}

export interface Trial {
  number: number;
  stage: string;
  values: number[];
  objective: number | null;
  feasible: boolean;
}

export interface PlanPoint {
  values: { name: string; pointer: string; unit: string; value: number }[];
  analytic: number | null;
  simulated: { mean: number | null; half_width_95: number | null };
}

export interface StudyResult {
  objective?: string;
  unit?: string;
  baseline?: PlanPoint;
  best?: PlanPoint;
  evaluations?: number;
  saving?: { mean: number | null; half_width: number | null; confidence: number };
  verdict?: string;
  words?: string;
}

export interface Study extends StudyHeader {
  changes: Change[] | string;
  variables: Variable[];
  baseline_run: number | null;
  best_run: number | null;
  result: StudyResult;
  trial_list: Trial[];
}

export interface Page {
  total: number;
  limit: number;
  offset: number;
}
export interface RunPage extends Page {
  runs: RunHeader[];
}
export interface StudyPage extends Page {
  studies: StudyHeader[];
}

export interface FunctionHead {
  key: string;
  summary: string;
  role: string;
  equation: string;
  provenance: string;
}

export type FieldKind = 'number' | 'integer' | 'flag' | 'text' | 'choice' | 'list' | 'structure' | 'alternatives';

export interface Field {
  name: string;
  symbol: string;
  unit: string;
  type: string;
  kind: FieldKind;
  nullable?: boolean;
  choices?: string[];
  meaning: string;
  required?: boolean;
  default?: unknown;
  example?: unknown;
  above?: number;
  at_least?: number;
  below?: number;
  at_most?: number;
}

export interface ModelFunction extends FunctionHead {
  source: { id: string; title: string; authors: string; published: string };
  inputs: Field[];
  outputs: Field[];
  notes: string[];
  example: { inputs: Record<string, unknown>; outputs: Record<string, unknown> };
}
export interface ModelList {
  total: number;
  functions: FunctionHead[];
}

export interface Version {
  program: string;
  version: string;
  database: string;
}
