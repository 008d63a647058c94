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

export interface Annotation {
  note: string;
  tags: string[];
}

export interface RunHeader extends Partial<Annotation> {
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
  /** Of every bit of the results and the course of events; null in runs of older programs. */
  fingerprint?: string | null;
  /** Only in lists, and only when asked for with ?kpis=. */
  kpis?: Kpi[];
  currency?: string;
}

/** A limit that an operation breaks, or a drawing that is not met. */
export interface Warning {
  pointer: string;
  operation: string;
  machine: string;
  limit: string;
  value: number;
  low: number;
  high: number;
  text: string;
}

export interface Run extends RunHeader {
  currency: string;
  kpis: Kpi[];
  warnings?: Warning[];
}

export interface StudyHeader extends Partial<Annotation> {
  id: number;
  name: string;
  scenario: string;
  kind: 'optimize' | 'sweep' | 'compare' | 'losses';
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
  type?: 'continuous' | 'integer' | 'categorical';
  options?: unknown[];
}

export interface Trial {
  number: number;
  stage: string;
  values: number[];
  objective: number | null;
  feasible: boolean;
  half_width?: number | null;
  replications?: number;
}

export interface PlanPoint {
  values: { name: string; pointer: string; unit: string; value: unknown; text?: string }[];
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
  /** What newer programs add: fronts, binding constraints, sensitivities. Shown as far as its form is known. */
  [more: string]: unknown;
}

export interface Study extends StudyHeader {
  changes: Change[] | string;
  variables: Variable[];
  baseline_run: number | null;
  best_run: number | null;
  result: StudyResult;
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
  read_only: boolean;
}

export interface RunScenario {
  run: number;
  name: string;
  scenario: string;
  changes: Change[];
}
export interface TrialPage extends Page {
  trials: Trial[];
}
export interface TagList {
  tags: { name: string; count: number }[];
}

/** The part of JSON Schema (draft 7) that the server's schemas use. */
export interface JsonSchema {
  type?: string;
  title?: string;
  description?: string;
  default?: unknown;
  enum?: unknown[];
  const?: unknown;
  minimum?: number;
  maximum?: number;
  exclusiveMinimum?: number;
  exclusiveMaximum?: number;
  minItems?: number;
  maxItems?: number;
  properties?: Record<string, JsonSchema>;
  required?: string[];
  items?: JsonSchema;
  oneOf?: JsonSchema[];
  anyOf?: JsonSchema[];
  $ref?: string;
}

export interface Kind {
  name: string;
  summary: string;
  sources: string[];
  schema: JsonSchema | null;
}
export interface KindList {
  total: number;
  kinds: Kind[];
}

export interface Quantity {
  name: string;
  value: number;
  unit: string;
  origin?: string;
  meaning?: string;
}
export interface Limit {
  name: string;
  value: number;
  at_most?: number;
  at_least?: number;
  unit: string;
  margin: number;
  met: boolean;
  origin?: string;
}
export interface Band {
  name: string;
  value: number;
  low: number;
  high: number;
  unit: string;
  inside: boolean;
  origin?: string;
}
export interface ElementLife {
  element: string;
  law: string;
  mean_min: number;
  cv: number;
  origin?: string;
}
export interface CutPlan {
  feasible: boolean;
  main_time_min: number;
  edge_life: ElementLife | null;
  more_elements: ElementLife[];
  scrap_probability: number;
  breakage_probability: number;
  quantities: Quantity[];
  limits: Limit[];
  forbidden_bands: Band[];
  consumables: Quantity[];
}
export interface SweepPoint {
  value: number;
  feasible?: boolean;
  quantities?: Record<string, number>;
  margins?: Record<string, number>;
  error?: string;
}
export interface SweepResult {
  pointer: string;
  points: SweepPoint[];
}
export interface ModelMap {
  output: string;
  values: (number | null)[][];
  refusals: Record<string, string>;
}
export interface CheckResult {
  valid: boolean;
  name: string;
  operations: { operation: string; main_time_min?: number; feasible?: boolean; error?: string }[];
  warnings?: Warning[];
}

export interface Job {
  id: number;
  kind: 'run' | 'study' | 'again' | 'trace' | 'losses' | 'resume' | 'fit';
  title: string;
  state: 'queued' | 'running' | 'finished' | 'failed' | 'cancelled';
  stage: string;
  done: number | null;
  of: number | null;
  left_s: number | null;
  best: number | null;
  elapsed_s: number;
  message: string;
  result: {
    run?: number;
    study?: number;
    baseline_run?: number;
    best_run?: number;
    of_run?: number;
    replication?: number;
    bytes?: number;
    values?: number;
    different?: number;
    identical?: boolean;
    first_difference?: string;
    versions?: string[];
    platforms?: string[];
  } | null;
}
