:- module(sg_style_en,
          [ style_en//1                 % +What
          ]).
:- use_module('../colour', [colour_name/2]).
:- use_module('../drawing/style', [line_type/3, style_role/1]).
/** <module> What is wrong with a style file, in English.

style_ko.pl has the same heads in Korean (tests/rules/drawing/style.plt).
*/

%!  style_en(+What)// is det.
%
%   The message for model_error(style(What)).

style_en(fact(Name, Arity)) -->
    [ 'a style file has no facts ~w/~w'-[Name, Arity], nl,
      '  Write line(Visibility, Role, Segment, Properties) or \c
       paper(Colour).' ].
style_en(visibility(_)) -->
    [ 'the visibility of a line is visible, hidden or any' ].
style_en(role(_)) -->
    { findall(Role, style_role(Role), Roles),
      atomic_list_concat(Roles, ', ', All)
    },
    [ 'the role of a line is any or one of', nl, '  ~w.'-[All] ].
style_en(segment(_)) -->
    [ 'a segment is a number, a name or any' ].
style_en(property(Property)) -->
    { findall(Type, line_type(Type, 1, _), Types),
      atomic_list_concat(Types, ', ', All)
    },
    [ '~p is no property of a line'-[Property], nl,
      '  Write width(Mm), colour(C), colour(Screen, Print), dashes(D), \c
       pen(N), layer(Name), none or shown;', nl,
      '  N is 1 to 255, Name at most 31 of a-z, A-Z, 0-9, $, - and _;', nl,
      '  dashes are solid, [Dash, Gap, ...] in mm, or ~w.'-[All] ].
style_en(properties(_)) -->
    [ 'properties are a list, like [width(0.5), colour(blue)]' ].
style_en(line_style(Style)) -->
    [ '~p is no style of a line'-[Style], nl,
      '  line_style/4 gives none, or style(Width, Colour, Dashes, Pen, \c
       Layer), as a style file has them: width in mm above 0,', nl,
      '  a colour or colour(Screen, Print), dashes, a pen from 1 to 255, a \c
       layer.' ].
style_en(colour(Colour)) -->
    { findall(Name, colour_name(Name, _), Names),
      atomic_list_concat(Names, ', ', All)
    },
    [ '~p is no colour'-[Colour], nl,
      '  Colours are rgb(R, G, B), numbers from 0 to 255, or one of', nl,
      '  ~w.'-[All] ].
