// The pages' frame: which page an address means, the states around it (loading, failed, token), the header.

import './style.css';
import { api, ApiError, initToken, setToken } from './api';
import { fragment, h } from './dom';
import { language, setLanguage, t } from './i18n';
import type { PageContent, PageContext, PageMaker } from './page';
import { comparePage } from './pages/compare';
import { fitPage } from './pages/fit';
import { homePage } from './pages/home';
import { modelPage } from './pages/model';
import { modelsPage } from './pages/models';
import { operationsPage } from './pages/operations';
import { reportPage } from './pages/report';
import { runPage } from './pages/run';
import { scenarioPage } from './pages/scenario';
import { sheetPage } from './pages/sheet';
import { studyPage } from './pages/study';
import { tracePage } from './pages/trace';
import { matchRoute } from './routes';

const pages: Record<string, PageMaker> = {
  home: homePage,
  run: runPage,
  study: studyPage,
  report: reportPage,
  sheet: sheetPage,
  compare: comparePage,
  scenario: scenarioPage,
  operations: operationsPage,
  trace: tracePage,
  fit: fitPage,
  models: modelsPage,
  model: modelPage,
};

const main = document.getElementById('main') as HTMLElement;
const live = document.getElementById('live') as HTMLElement;
let leave: () => void = () => {};

function header(): void {
  document.documentElement.lang = language();
  const skip = document.getElementById('skip');
  if (skip) {
    skip.textContent = t('nav.skip');
    skip.onclick = (event) => {
      event.preventDefault();
      main.focus();
    };
  }
  const here = location.hash;
  const link = (href: string, text: string, active: boolean) => h('a', { href, 'aria-current': active ? 'page' : undefined }, text);
  const inside = (part: string) => here.startsWith(`#/${part}`);
  const elsewhere = ['models', 'scenario', 'operations', 'trace', 'fit'].some(inside);
  const select = h(
    'select',
    {
      'aria-label': t('nav.language'),
      onchange: () => {
        setLanguage(select.value === 'uk' ? 'uk' : 'en');
        void show();
      },
    },
    h('option', { value: 'en', lang: 'en', selected: language() === 'en' }, 'English'),
    h('option', { value: 'uk', lang: 'uk', selected: language() === 'uk' }, 'Українська'),
  );
  document.getElementById('top')?.replaceChildren(
    h('a', { class: 'brand', href: '#/' }, h('strong', {}, 'Verstat'), h('span', { class: 'tagline' }, t('app.tagline'))),
    h('nav', { 'aria-label': t('nav.main') }, link('#/', t('nav.home'), !elsewhere), link('#/scenario', t('nav.scenario'), inside('scenario')), link('#/operations', t('nav.operations'), inside('operations')), link('#/models', t('nav.models'), inside('models')), link('#/trace', t('nav.trace'), inside('trace')), link('#/fit', t('fit.title'), inside('fit'))),
    select,
  );
}

function failed(error: unknown): Node {
  if (error instanceof ApiError && error.status === 401) return tokenForm();
  const words = error instanceof ApiError ? (error.status === 0 ? t('state.offline') : error.message) : String(error);
  return h(
    'div',
    { class: 'state', role: 'alert' },
    h('h1', {}, t('state.failed')),
    h('p', {}, words),
    h('p', {}, h('button', { type: 'button', onclick: () => void show() }, t('state.retry')), ' ', h('a', { href: '#/' }, t('state.home'))),
  );
}

function tokenForm(): Node {
  const input = h('input', { id: 'token', type: 'password', autocomplete: 'off', required: true });
  const note = h('p', { class: 'bad', role: 'alert' });
  return h(
    'form',
    {
      class: 'state',
      onsubmit: (event: Event) => {
        event.preventDefault();
        setToken(input.value.trim());
        api.version().then(
          () => void show(),
          (e: unknown) => (note.textContent = e instanceof ApiError && e.status === 401 ? t('token.wrong') : t('state.offline')),
        );
      },
    },
    h('h1', {}, t('token.head')),
    h('p', {}, t('token.text')),
    h('p', { class: 'row' }, h('label', { for: 'token' }, t('token.label')), input, h('button', { type: 'submit' }, t('token.send'))),
    note,
  );
}

async function show(): Promise<void> {
  leave();
  const controller = new AbortController();
  const drawers: (() => void)[] = [];
  const cleaners: (() => void)[] = [];
  leave = () => {
    controller.abort();
    for (const clean of cleaners) clean();
    cleaners.length = 0;
  };
  const context: PageContext = { signal: controller.signal, whenShown: (d) => drawers.push(d), whenLeft: (c) => cleaners.push(c) };
  header();
  main.setAttribute('aria-busy', 'true');
  // Most pages come sooner than a loading state could be read.
  const loading = setTimeout(() => main.replaceChildren(h('p', { class: 'state' }, t('page.loading'))), 200);
  let content: PageContent;
  try {
    const route = matchRoute(location.hash);
    const maker = route ? pages[route.page] : undefined;
    content =
      route && maker
        ? await maker(context, route.parameters)
        : { title: t('state.notFound'), body: h('div', { class: 'state' }, h('h1', {}, t('state.notFound')), h('a', { href: '#/' }, t('state.home'))) };
  } catch (error) {
    if (controller.signal.aborted) return;
    content = { title: t('state.failed'), body: failed(error) };
  } finally {
    clearTimeout(loading);
  }
  if (controller.signal.aborted) return;
  document.title = `${content.title} · Verstat`;
  main.replaceChildren(fragment(content.body));
  main.removeAttribute('aria-busy');
  live.textContent = content.title;
  for (const draw of drawers) draw();
}

initToken();
addEventListener('hashchange', () => {
  scrollTo(0, 0);
  void show();
  main.focus({ preventScroll: true });
});
void show();
