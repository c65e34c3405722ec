// Forms for the settings of scenes and techniques, made from the catalogue.
import {fault, plain} from './link.js';

// An element with properties, attributes (aria-..., for, title) and children.
export function make(tag, properties = {}, ...children) {
  const element = document.createElement(tag);
  for (const [key, value] of Object.entries(properties)) {
    if (key.includes('-') || key === 'for' || key === 'role') element.setAttribute(key, value);
    else element[key] = value;
  }
  element.append(...children);
  return element;
}

// Fills a select with [value, text] pairs.
export function fillSelect(select, pairs, chosen) {
  select.replaceChildren(...pairs.map(
    ([value, text]) => new Option(text, value, false, String(value) === String(chosen))));
}

function range(setting) {
  const text = {
    number: `${setting.low} to ${setting.high}, `, whole: `whole, ${setting.low} to ${setting.high}, `,
  }[setting.kind] ?? '';
  return `${text}default ${plain(setting)}`;
}

function control(setting, id, value) {
  const about = {id, title: `${setting.meaning}; ${range(setting)}`, 'aria-describedby': `${id}-help`};
  switch (setting.kind) {
    case 'flag':
      return make('input', {...about, type: 'checkbox', checked: value === 'on'});
    case 'word': {
      const select = make('select', about);
      fillSelect(select, setting.choices.map(word => [word, word]), value);
      return select;
    }
    case 'text':
      return make('input', {...about, type: 'text', value, spellcheck: false, autocomplete: 'off'});
    default:
      return make('input', {...about, type: 'number', value, min: setting.low, max: setting.high,
                            step: setting.kind === 'whole' ? 1 : 'any', inputMode: 'decimal'});
  }
}

export class Form {
  // place: where it stands; prefix: of ids; onChange(values): settings that differ from the defaults.
  constructor(place, prefix, onChange) {
    this.place = place;
    this.prefix = prefix;
    this.onChange = onChange;
  }

  // Shows the settings of a scene or technique. What is shown already stays, with the focus in it.
  show(settings, values) {
    const about = JSON.stringify([settings, values]);
    if (about === this.about) return;
    const focus = this.place.contains(document.activeElement) ? document.activeElement.id : '';
    this.fill(settings, values);
    if (focus) document.getElementById(focus)?.focus();
  }

  fill(settings, values) {
    this.about = JSON.stringify([settings, values]);
    this.settings = settings;
    this.values = {...values};
    this.fields = settings.map(setting => this.field(setting));
    this.back = make('button', {type: 'button', textContent: 'All defaults'});
    this.back.hidden = Object.keys(values).length === 0;
    this.back.onclick = () => {
      this.fill(settings, {});
      this.onChange({});
      this.place.querySelector('input, select')?.focus();  // the button has gone
    };
    this.place.replaceChildren(...this.fields, this.back);
  }

  field(setting) {
    const id = `${this.prefix}-${setting.key}`;
    const input = control(setting, id, this.values[setting.key] ?? plain(setting));
    const help = make('small', {id: `${id}-help`, textContent: `${setting.meaning} (${range(setting)})`});
    const wrong = make('small', {className: 'wrong', role: 'alert'});
    const unit = setting.unit === '-' || !setting.unit ? []
      : [make('span', {className: 'unit', textContent: setting.unit})];
    const field = make('div', {className: 'field'},
      make('label', {className: 'name', for: id, textContent: setting.key, title: setting.meaning}),
      make('span', {className: 'value'}, input, ...unit), help, wrong);
    const mark = () => field.classList.toggle('changed', setting.key in this.values);
    mark();
    input.onchange = () => {
      const text = setting.kind === 'flag' ? (input.checked ? 'on' : 'off') : input.value;
      const mistake = fault(setting, text);
      wrong.textContent = mistake ? `${text === '' ? 'nothing' : text}: ${mistake}` : '';
      input.setAttribute('aria-invalid', String(mistake !== ''));
      if (mistake) return;
      if (plain(setting, text) === plain(setting)) delete this.values[setting.key];
      else this.values[setting.key] = text;
      mark();
      this.back.hidden = Object.keys(this.values).length === 0;
      this.about = JSON.stringify([this.settings, this.values]);
      this.onChange({...this.values});
    };
    return field;
  }
}

// `damping=none, passes=8`: what was changed, in a line.
export const changes = values => Object.entries(values).map(([key, value]) => `${key}=${value}`).join(', ');

// A list of scenes or techniques for a select: name and what it is.
export const choices = list => list.map(({name, summary}) => [name, `${name}: ${summary}`]);
