// The server's REST interface. Every page asks through here; nothing else is ever requested.

import type { ModelFunction, ModelList, Run, RunPage, Study, StudyPage, Version } from './types';

export class ApiError extends Error {
  constructor(
    readonly status: number,
    message: string,
    /** Input of a model function that is to blame, if one is. */
    readonly input: string = '',
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
  try {
    const body = (await response.json()) as { error?: { message?: string; input?: string } };
    message = body.error?.message ?? message;
    input = body.error?.input ?? '';
  } catch {
    // The status has to do.
  }
  return new ApiError(response.status, message, input);
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

export const api = {
  version: (signal?: AbortSignal) => get<Version>('version', signal),
  runs: (limit: number, offset: number, signal?: AbortSignal) =>
    get<RunPage>(`runs?limit=${limit}&offset=${offset}&kpis=cost_per_part,throughput_per_h`, signal),
  run: (id: string, replications: boolean, signal?: AbortSignal) =>
    get<Run>(`runs/${encodeURIComponent(id)}${replications ? '?replications=1' : ''}`, signal),
  studies: (limit: number, offset: number, signal?: AbortSignal) => get<StudyPage>(`studies?limit=${limit}&offset=${offset}`, signal),
  /** Without its trials: what was found, for lists. */
  studyHead: (id: string, signal?: AbortSignal) => get<Omit<Study, 'trial_list'>>(`studies/${encodeURIComponent(id)}?trials=0`, signal),
  study: (id: string, signal?: AbortSignal) => get<Study>(`studies/${encodeURIComponent(id)}`, signal),
  models: (signal?: AbortSignal) => get<ModelList>('models', signal),
  model: (key: string, signal?: AbortSignal) => get<ModelFunction>(`models/${encodeURIComponent(key)}`, signal),
  evaluate: async (key: string, inputs: Record<string, unknown>): Promise<Record<string, unknown>> => {
    const response = await request(`models/${encodeURIComponent(key)}/eval`, {
      method: 'POST',
      headers: { 'Content-Type': 'application/json', 'X-Verstat': '1' },
      body: JSON.stringify({ inputs }),
    });
    return ((await response.json()) as { outputs: Record<string, unknown> }).outputs;
  },
  /** Saves what the server answers as a file; a plain link could not send the token. */
  download: async (path: string, file: string): Promise<void> => {
    const blob = await (await request(path)).blob();
    const url = URL.createObjectURL(blob);
    const link = document.createElement('a');
    link.href = url;
    link.download = file;
    link.click();
    setTimeout(() => URL.revokeObjectURL(url), 10_000);
  },
};
