// The server's REST interface. Every page asks through here; nothing else is ever requested.

import { t } from './i18n';
import { readEvents } from './logic/events';
import type { Annotation, Change, CheckResult, CutPlan, Job, JsonSchema, KindList, ModelFunction, ModelList, ModelMap, Run, RunPage, RunScenario, Study, StudyPage, SweepResult, TagList, TrialPage, Version } from './types';

export class ApiError extends Error {
  constructor(
    readonly status: number,
    message: string,
    /** Input of a model function that is to blame, if one is. */
    readonly input: string = '',
    /** Place in a scenario that is to blame, a JSON pointer, if one is. */
    readonly pointer: string = '',
  ) {
    super(message);
  }
}

const tokenKey = 'verstat.token';
let token = '';

/** Takes the token from the address (?token=...), where `verstat serve` prints it, and removes it from sight. */
export function initToken(): void {
  const url = new URL(location.href);
  const given = url.searchParams.get('token');
  if (given !== null) {
    url.searchParams.delete('token');
    history.replaceState(null, '', url.pathname + url.search + url.hash);
    setToken(given);
    return;
  }
  try {
    token = sessionStorage.getItem(tokenKey) ?? '';
  } catch {
    token = '';
  }
}

export function setToken(next: string): void {
  token = next;
  try {
    sessionStorage.setItem(tokenKey, next);
  } catch {
    // Kept for this page only, then.
  }
}

function headers(extra: Record<string, string> = {}): Record<string, string> {
  return token ? { ...extra, Authorization: `Bearer ${token}` } : extra;
}

async function failure(response: Response): Promise<ApiError> {
  let message = `HTTP ${response.status}`;
  let input = '';
  let pointer = '';
  try {
    const body = (await response.json()) as { error?: { message?: string; input?: string; pointer?: string } };
    message = body.error?.message ?? message;
    input = body.error?.input ?? '';
    pointer = body.error?.pointer ?? '';
  } catch {
    // The status has to do.
  }
  return new ApiError(response.status, message, input, pointer);
}

async function request(path: string, init: RequestInit = {}): Promise<Response> {
  let response: Response;
  try {
    response = await fetch(`/api/v1/${path}`, { ...init, headers: headers(init.headers as Record<string, string> | undefined) });
  } catch (e) {
    if (e instanceof DOMException && e.name === 'AbortError') throw e;
    throw new ApiError(0, '');
  }
  if (!response.ok) throw await failure(response);
  return response;
}

async function get<T>(path: string, signal?: AbortSignal): Promise<T> {
  return (await request(path, signal ? { signal } : {})).json() as Promise<T>;
}

/** What `verstat serve` takes at once. It hangs up on more, which a page could not tell from a server that is gone. */
const mostBytes = 4 * 1024 * 1024;

async function send<T>(method: 'POST' | 'PUT' | 'DELETE', path: string, body?: unknown, signal?: AbortSignal): Promise<T> {
  const text = body === undefined ? undefined : JSON.stringify(body);
  const size = text === undefined ? 0 : new Blob([text]).size;
  if (size > mostBytes) throw new ApiError(413, t('state.tooLarge', { size: (size / 1048576).toFixed(1), most: mostBytes / 1048576 }));
  const response = await request(path, {
    method,
    headers: { 'X-Verstat': '1', ...(body === undefined ? {} : { 'Content-Type': 'application/json' }) },
    ...(text === undefined ? {} : { body: text }),
    ...(signal ? { signal } : {}),
  });
  return response.json() as Promise<T>;
}

export interface ListOptions {
  limit: number;
  offset: number;
  search?: string;
  tag?: string;
  sort?: string;
  order?: 'asc' | 'desc';
}

function listQuery(options: ListOptions, extra: Record<string, string> = {}): string {
  const query = new URLSearchParams({ limit: String(options.limit), offset: String(options.offset) });
  for (const key of ['search', 'tag', 'sort', 'order'] as const) if (options[key]) query.set(key, options[key]);
  for (const [key, value] of Object.entries(extra)) query.set(key, value);
  return query.toString();
}

export type PlanRequest = { operation: unknown; changes?: Change[] } | { scenario: unknown; operation: string; changes?: Change[] };

/** Hands a file to the browser's downloads. */
export function saveBlob(blob: Blob, file: string): void {
  const url = URL.createObjectURL(blob);
  const link = document.createElement('a');
  link.href = url;
  link.download = file;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

export const api = {
  version: (signal?: AbortSignal) => get<Version>('version', signal),
  runs: (options: ListOptions, signal?: AbortSignal) => get<RunPage>(`runs?${listQuery(options, { kpis: 'cost_per_part,throughput_per_h' })}`, signal),
  run: (id: string, replications: boolean, signal?: AbortSignal) =>
    get<Run>(`runs/${encodeURIComponent(id)}?notes=1&warnings=1${replications ? '&replications=1' : ''}`, signal),
  runScenario: (id: string, signal?: AbortSignal) => get<RunScenario>(`runs/${encodeURIComponent(id)}/scenario`, signal),
  studies: (options: ListOptions, signal?: AbortSignal) => get<StudyPage>(`studies?${listQuery(options)}`, signal),
  /** Without its trials. */
  study: (id: string, signal?: AbortSignal) => get<Study>(`studies/${encodeURIComponent(id)}?trials=0&notes=1`, signal),
  trials: (id: string, query: string, signal?: AbortSignal) => get<TrialPage>(`studies/${encodeURIComponent(id)}/trials?${query}`, signal),
  tags: (signal?: AbortSignal) => get<TagList>('tags', signal),
  annotate: (what: 'runs' | 'studies', id: number, annotation: Annotation) => send<Annotation>('PUT', `${what}/${id}/notes`, annotation),
  kinds: (signal?: AbortSignal) => get<KindList>('kinds', signal),
  schema: (signal?: AbortSignal) => get<JsonSchema>('schema', signal),
  plan: (body: PlanRequest, signal?: AbortSignal) => send<CutPlan>('POST', 'plan', body, signal),
  planSweep: (body: PlanRequest, pointer: string, values: number[], signal?: AbortSignal) =>
    send<SweepResult>('POST', 'plan', { ...body, sweep: { pointer, values } }, signal),
  check: (scenario: unknown, changes: Change[], signal?: AbortSignal) => send<CheckResult>('POST', 'check', { scenario, changes }, signal),
  jobs: (signal?: AbortSignal) => get<{ jobs: Job[] }>('jobs', signal),
  startJob: (body: Record<string, unknown>) => send<Job>('POST', 'jobs', body),
  /** What a finished trace has printed. */
  jobOutput: (id: number, signal?: AbortSignal) => get<unknown>(`jobs/${id}/output`, signal),
  cancelJob: (id: number) => send<Job>('DELETE', `jobs/${id}`),
  /** Follows a job until it is over or `signal` aborts. */
  followJob: async (id: number, onJob: (job: Job) => void, signal: AbortSignal): Promise<void> => {
    const response = await request(`jobs/${id}/events`, { signal });
    if (!response.body) throw new ApiError(0, '');
    await readEvents(response.body, (event) => {
      if (event.name === 'job') onJob(JSON.parse(event.data) as Job);
    });
  },
  models: (signal?: AbortSignal) => get<ModelList>('models', signal),
  model: (key: string, signal?: AbortSignal) => get<ModelFunction>(`models/${encodeURIComponent(key)}`, signal),
  evaluate: async (key: string, inputs: Record<string, unknown>, signal?: AbortSignal): Promise<Record<string, unknown>> =>
    (await send<{ outputs: Record<string, unknown> }>('POST', `models/${encodeURIComponent(key)}/eval`, { inputs }, signal)).outputs,
  map: (key: string, body: Record<string, unknown>, signal?: AbortSignal) => send<ModelMap>('POST', `models/${encodeURIComponent(key)}/map`, body, signal),
  /** Saves what the server answers as a file; a plain link could not send the token. */
  download: async (path: string, file: string): Promise<void> => {
    saveBlob(await (await request(path)).blob(), file);
  },
};
