:- encoding(utf8).
:- module(sg_pattern_title,
          [ pattern_title/2,            % +D, -Title
            pattern_titles/2,          % +Ds, -Titles
            piece_title/3               % +Titles, +Piece, -Title
          ]).
:- use_module('../language', [language/1]).
:- use_module('../development/polygon_name', [segment_title/2]).
:- use_module('../primitive/primitive', [primitive/1]).
:- use_module('../solid/trimmed', [part_named/2, part_named/4]).
:- use_module('../store', [piece/3, segment/3]).
:- use_module('../unfolding/unfold', [pattern_of/2]).
:- use_module('../unfolding/unfold_mirror', [is_mirrored/1]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [member/2]).
/** <module> What patterns and their pieces are called.

Who cuts out several patterns has to tell them apart: each piece, and each table
of true lengths, has the name that the report has.
*/

%!  pattern_title(+D, -Title) is det.
%
%   Title, a string, is what the segment is called that pattern D is of, and the
%   part or the leaf of it that D is of alone; and that it is mirrored.

pattern_title(D, Title) :-
    (   is_mirrored(D)
    ->  plain_title(D, Plain),
        language(Language),
        mirrored_word(Language, Word),
        format(string(Title), '~s, ~w', [Plain,Word])
    ;   plain_title(D, Title)
    ).

mirrored_word(en, mirrored).
mirrored_word(ko, 좌우대칭).

plain_title(D, Title) :-
    pattern_of(D, T),
    part_named(T, S),
    segment_title(S, Whole),
    (   segment(D, pattern, true_development(T, Part0)),
        part_named(T, Part0, _, Part),
        part_title(Part, PartTitle)
    ->  format(string(Title), '~w/~w', [Whole,PartTitle])
    ;   format(string(Title), '~w', [Whole])
    ).

%   part_title(Part, Title): Part is not all that is round of its segment.

part_title(Leaf/_, Title) :-
    !,
    segment_title(Leaf, Title),
    \+ primitive(Title).
part_title(Part, Part) :-
    \+ memberchk(Part, [side,sphere]).

%!  pattern_titles(+Ds:list, -Titles:list) is det.
%
%   Titles is a list of D-Title for the patterns Ds: [] if they are fewer than
%   two. Where those of several segments would have one title the number of the
%   segment goes before it.

pattern_titles(Ds, Titles) :-
    (   Ds = [_,_|_]
    ->  maplist(titled, Ds, Titled),
        maplist(told_apart(Titled), Titled, Titles)
    ;   Titles = []
    ).

titled(D, titled(D, S, Title)) :-
    pattern_of(D, T),
    part_named(T, S),
    pattern_title(D, Title).

told_apart(Titled, titled(D, S, Title0), D-Title) :-
    (   member(titled(_, Other, Title0), Titled),
        Other \== S
    ->  format(string(Title), '~d ~s', [S,Title0])
    ;   Title = Title0
    ).

%!  piece_title(+Titles:list, +Piece, -Title) is semidet.
%
%   Title is what is written on Piece, name(D,K,Part): the title of pattern D of
%   Titles; with (K) if D has several pieces, and (K.Part) if the piece was
%   divided for the page. Fails if D has none.

piece_title(Titles, name(D,K,Part), Title) :-
    memberchk(D-Whole, Titles),
    (   Part =\= 0
    ->  format(string(Title), '~s (~d.~d)', [Whole,K,Part])
    ;   once(piece(D, _, 2))
    ->  format(string(Title), '~s (~d)', [Whole,K])
    ;   Title = Whole
    ).
