# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Scripts that complete the commands of the program in shells."""

from __future__ import annotations

import argparse
import shlex
from typing import Any, Optional

SHELLS = ("bash", "zsh", "fish")


def subcommands(parser: argparse.ArgumentParser) -> dict[str, argparse.ArgumentParser]:
    """The parsers of the subcommands, by their names."""
    return dict(_commands(parser).choices)


def option_strings(parser: argparse.ArgumentParser) -> list[str]:
    """The names of the options of a parser."""
    return [name for action in _options(parser) for name in action.option_strings]


def script(shell: str, parser: argparse.ArgumentParser) -> str:
    """The script for a shell."""
    return {"bash": _bash, "zsh": _zsh, "fish": _fish}[shell](parser)


def _commands(parser: argparse.ArgumentParser) -> Any:
    return next(of for of in parser._actions if isinstance(of, argparse._SubParsersAction))


def _descriptions(parser: argparse.ArgumentParser) -> dict[str, str]:
    """What each subcommand does."""
    return {of.dest: of.help for of in _commands(parser)._choices_actions}


def _options(parser: argparse.ArgumentParser) -> list[argparse.Action]:
    return [action for action in parser._actions if action.option_strings]


def _positional_choices(parser: argparse.ArgumentParser) -> list[str]:
    """What a subcommand takes in place of files."""
    return [
        str(choice)
        for action in parser._actions
        if not action.option_strings
        for choice in action.choices or ()
    ]


def _metavars(option: argparse.Action) -> tuple[str, ...]:
    """The names of what follows an option."""
    if option.nargs == 0:
        return ()
    if isinstance(option.metavar, tuple):
        return option.metavar
    return (option.metavar or option.dest.upper(),)


def _bash(parser: argparse.ArgumentParser) -> str:
    cases = []
    for command, of in subcommands(parser).items():
        numbers, words = [], _positional_choices(of)
        files = "" if words else "; files=-f"
        for option in _options(of):
            words += option.option_strings
            after = [f"'{command} {name}'" for name in option.option_strings]
            if option.choices:
                cases.append(f"    {'|'.join(after)}) words='{' '.join(option.choices)}' ;;")
            elif _metavars(option) and "FILE" not in _metavars(option):
                numbers += after
        if numbers:
            cases.append(f"    {'|'.join(numbers)}) words= ;;")
        cases.append(f"    '{command} '*) words='{' '.join(words)}'{files} ;;")
    return f"""\
_gcv() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} words='{" ".join(subcommands(parser))}' files=
  [ "$COMP_CWORD" -gt 1 ] && case "${{COMP_WORDS[1]}} ${{COMP_WORDS[COMP_CWORD - 1]}}" in
{_lines(cases)}
  esac
  mapfile -t COMPREPLY < <(compgen $files -W "$words" -- "$word")
}}
complete -o filenames -F _gcv gcv"""


def _zsh(parser: argparse.ArgumentParser) -> str:
    commands, cases = [], []
    for command, text in _descriptions(parser).items():
        of = subcommands(parser)[command]
        commands.append(f"    {command}:{_quoted(text)}")
        arguments = []
        for option in _options(of):
            values = "".join(f":{name}:{_zsh_values(option)}" for name in _metavars(option))
            for name in option.option_strings:
                arguments.append(_quoted(f"*{name}[{option.help}]{values}"))
        choices = " ".join(_positional_choices(of))
        arguments.append(_quoted(f"*:file:({choices})" if choices else "*:file:_files"))
        cases.append(f"    {command}) _arguments {' '.join(arguments)} ;;")
    return f"""\
#compdef gcv
_gcv() {{
  local -a commands=(
{_lines(commands)}
  )
  (( CURRENT == 2 )) && {{ _describe command commands; return; }}
  shift words
  (( CURRENT-- ))
  case $words[1] in
{_lines(cases)}
  esac
}}
if [ "$funcstack[1]" = _gcv ]; then _gcv "$@"; else compdef _gcv gcv; fi"""


def _zsh_values(option: argparse.Action) -> str:
    if option.choices:
        return f"({' '.join(option.choices)})"
    return "_files" if "FILE" in _metavars(option) else " "


def _fish(parser: argparse.ArgumentParser) -> str:
    lines = []
    for command, text in _descriptions(parser).items():
        of = subcommands(parser)[command]
        lines.append(f"complete -c gcv -n __fish_use_subcommand -a {command} -d {_quoted(text)}")
        begin = f"complete -c gcv -n '__fish_seen_subcommand_from {command}'"
        if choices := _positional_choices(of):
            lines.append(f"{begin} -f -a '{' '.join(choices)}'")
        for option in _options(of):
            names = " ".join(
                f"-l {name[2:]}" if name.startswith("--") else f"-s {name[1:]}"
                for name in option.option_strings
            )
            values = f" -x -a '{' '.join(option.choices)}'" if option.choices else ""
            if _metavars(option) and not values:
                values = " -r" if "FILE" in _metavars(option) else " -x"
            lines.append(f"{begin} {names}{values} -d {_quoted(option.help)}")
    return _lines(lines)


def _lines(of: list[str]) -> str:
    return "\n".join(of)


def _quoted(text: Optional[str]) -> str:
    return shlex.quote(text or "")
