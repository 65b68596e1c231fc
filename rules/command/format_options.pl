:- module(sg_format_options,
          [ format_options_told/3       % +Verb, +Files, +Options
          ]).
:- use_module(library(lists), [member/2]).
:- use_module(library(option), [option/2, option/3]).
/** <module> Options of a file format, where no file has it.

What needs another option is looked at by each verb (unfold_options.pl).
*/

%!  format_options_told(+Verb, +Files:list, +Options:list) is det.
%
%   A warning for each of Options that is about files of a format, if none of
%   Files, or none that Options write, has it. Options may be those of many
%   jobs, so it is no error.

format_options_told(Verb, Files, Options) :-
    forall(( format_option(Name, Where, Format),
             option_given(Name, Options),
             \+ ( has_option(Name, Format, Options, Other),
                  of_format(Where, Verb-Files, Options, Other) ) ),
           ( atom_concat('--', Name, Option),
             print_message(warning,
                           sanggwan(format_option(Option, Format))) )).

format_option(dpi,   written, png).
format_option(png,   written, png).
format_option(lod,   read,    json).
format_option(close, read,    json).

%   has_option(Name, Format, Options, Other): files of the format Other have it:
%   shading is in dots in all that can hold them.

has_option(_, Format, _, Format).
has_option(dpi, _, Options, Format) :-
    option(shade(Shade), Options),
    Shade \== hatch,
    member(Format, [svg,pdf,ps,eps]).

option_given(Name, Options) :-
    Option =.. [Name,Value],
    option(Option, Options),
    Value \== false.

%   of_format(Where, Verb-Files, Options, Format): a file has it.

of_format(read, _-Files, Options, Format) :-
    member(File, Files),
    (   File == (-)
    ->  option(from(Format), Options, pl)
    ;   ending(File, Format)
    ).
of_format(written, Verb-_, Options, Format) :-
    option(output(Files), Options, []),
    member(File, Files),
    (   File == (-)
    ->  ( Verb == render -> Usual = png ; Usual = svg ),
        option(format(Format), Options, Usual)
    ;   ending(File, Format)
    ).

ending(File, Ending) :-
    file_name_extension(_, Ending0, File),
    downcase_atom(Ending0, Ending).
