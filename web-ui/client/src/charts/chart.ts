// A chart in a page: drawn when the page is shown, redrawn when light turns to dark, thrown away when it is left.
// Charts are pure functions from data and theme to an ECharts option; the page holds the same numbers as a table.

import { h } from '../dom';
import type { PageContext } from '../page';
import type { Option } from './echarts';
import { currentTheme, type Theme } from './theme';

export interface Chart {
  element: HTMLElement;
  redraw: () => void;
}

/**
 * @param label what a screen reader says in place of the picture
 * @param heightClass CSS class that gives the height
 */
export function chart(context: PageContext, label: string, heightClass: string, option: (theme: Theme) => Option): Chart {
  const element = h('div', { class: `chart ${heightClass}`, role: 'img', 'aria-label': label });
  let redraw = () => {};
  let left = false;
  const dark = matchMedia('(prefers-color-scheme: dark)');
  const onTheme = () => redraw();
  context.whenShown(() => {
    void import('./echarts').then(({ init }) => {
      if (left) return;
      const instance = init(element, null, { renderer: 'canvas' });
      redraw = () => {
        const theme = currentTheme();
        instance.setOption({ animation: false, textStyle: { fontFamily: theme.font, color: theme.text }, ...option(theme) }, true);
        element.dataset['drawn'] = 'yes';
      };
      redraw();
      const observer = new ResizeObserver(() => instance.resize());
      observer.observe(element);
      dark.addEventListener('change', onTheme);
      context.whenLeft(() => {
        observer.disconnect();
        dark.removeEventListener('change', onTheme);
        instance.dispose();
      });
    });
  });
  context.whenLeft(() => {
    left = true;
  });
  return { element, redraw: () => redraw() };
}

/** Tooltips are drawn on the canvas: the content security policy leaves no room for HTML ones. */
export function tooltip(theme: Theme): { renderMode: 'richText'; backgroundColor: string; borderColor: string; textStyle: { color: string; fontSize: number }; confine: boolean } {
  return { renderMode: 'richText', backgroundColor: theme.panel, borderColor: theme.line, textStyle: { color: theme.text, fontSize: 12 }, confine: true };
}
