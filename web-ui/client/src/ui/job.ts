// A job under way: state, progress, time left, best so far, cancel.

import { api, ApiError } from '../api';
import { h } from '../dom';
import { significant, whole } from '../format';
import { t, type Key } from '../i18n';
import type { PageContext } from '../page';
import type { Job } from '../types';

export function duration(seconds: number): string {
  if (seconds < 90) return t('time.seconds', { n: whole(seconds) });
  if (seconds < 5400) return t('time.minutes', { n: whole(seconds / 60) });
  return t('time.hours', { n: significant(seconds / 3600, 2) });
}

export const isOver = (job: Job): boolean => job.state === 'finished' || job.state === 'failed' || job.state === 'cancelled';

/** Follows `first` until it is over; `onEnd` is called once with what it came to. */
export function jobPanel(context: PageContext, first: Job, onEnd: (job: Job) => void): HTMLElement {
  const words = h('p', { class: 'job-words', role: 'status' });
  const bar = h('progress', { 'aria-label': first.title });
  const cancel = h('button', { type: 'button', class: 'quiet', onclick: () => {
    cancel.disabled = true;
    api.cancelJob(first.id).catch(() => (cancel.disabled = false));
  } }, t('job.cancel'));
  const note = h('p', { class: 'bad', role: 'alert' });
  const panel = h('section', { class: 'panel job', 'data-job': first.id, 'data-state': first.state }, h('h2', {}, first.title, h('span', { class: 'unit' }, ` ${t(`job.kind.${first.kind}`)}`)), words, h('p', { class: 'row' }, bar, cancel), note);
  const show = (job: Job) => {
    panel.dataset['state'] = job.state;
    const progress = job.done !== null && job.of !== null && job.of > 0;
    if (progress) {
      bar.max = job.of ?? 1;
      bar.value = job.done ?? 0;
    } else if (isOver(job)) {
      bar.max = 1;
      bar.value = job.state === 'finished' ? 1 : 0;
    } else bar.removeAttribute('value');
    words.textContent = [
      t(`job.${job.state}` as Key),
      progress && !isOver(job) ? t('job.progress', { stage: job.stage, done: whole(job.done ?? 0), of: whole(job.of ?? 0) }) : '',
      job.best !== null && !isOver(job) ? t('job.best', { best: significant(job.best) }) : '',
      job.left_s !== null && !isOver(job) ? t('job.left', { time: duration(job.left_s) }) : '',
      isOver(job) && job.state !== 'cancelled' ? duration(job.elapsed_s) : '',
    ]
      .filter(Boolean)
      .join(' · ');
    note.textContent = job.state === 'failed' ? job.message : '';
    if (isOver(job)) cancel.remove();
  };
  show(first);
  const abort = new AbortController();
  context.whenLeft(() => abort.abort());
  let last = first;
  const follow = async () => {
    try {
      await api.followJob(first.id, (job) => show((last = job)), abort.signal);
    } catch (e) {
      if (abort.signal.aborted) return;
      note.textContent = e instanceof ApiError && e.message ? e.message : t('state.offline');
    }
    if (isOver(last)) onEnd(last);
    else if (!abort.signal.aborted) setTimeout(() => void follow(), 2000);
  };
  void follow();
  return panel;
}

/** Panels of the jobs that are not over, wherever they were started. */
export async function activeJobs(context: PageContext, kinds: readonly Job['kind'][], onEnd: (job: Job) => void): Promise<HTMLElement[]> {
  const { jobs } = await api.jobs(context.signal);
  return jobs.filter((job) => !isOver(job) && kinds.includes(job.kind)).map((job) => jobPanel(context, job, onEnd));
}
