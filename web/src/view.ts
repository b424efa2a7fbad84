// A part of the page: an element that is made once, and brought up to date with every change.
import type { Model } from './model';

export interface View {
  element: HTMLElement;
  update: (model: Model) => void;
}
