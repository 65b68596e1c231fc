:- module(sg_spelling,
          [ near_words/3                % +Word, +Words, -Near
          ]).
:- use_module(library(lists), [append/3, last/2, member/2, numlist/3]).
:- use_module(library(pairs), [group_pairs_by_key/2]).
/** <module> Which known word somebody may have meant.

Two words are as far apart as the least number of letters that have to be put
in, left out or replaced, or of neighbours that change places, to make one of
the other. A word is near that is no farther than a third of the letters that
were written, but one at least; one that begins with what was written is near
too.

@see F. J. Damerau, A technique for computer detection and correction of
spelling errors, Comm. ACM 7, 1964
*/

% Fewer letters than this say nothing.
least_letters(3).

% More are no word that was mistyped.
most_letters(64).

%!  near_words(+Word, +Words, -Near) is det.
%
%   Near are those of the atoms Words that are nearest to the atom Word, in the
%   standard order; [] if none is near. Capital letters count as small ones.

near_words(Word, Words, Near) :-
    letters(Word, Letters),
    findall(Apart-Other,
            ( member(Other, Words), word_apart(Letters, Other, Apart) ),
            Pairs0),
    sort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Groups),
    (   Groups = [_-Near0|_]
    ->  Near = Near0
    ;   Near = []
    ).

letters(Word, Letters) :-
    downcase_atom(Word, Small),
    atom_chars(Small, Letters).

%   word_apart(Letters, Other, Apart) is semidet: of what is near. A word whose
%   end was left out is farther than all others.

word_apart(Letters, Other, Apart) :-
    length(Letters, N),
    least_letters(Least),
    N >= Least,
    letters(Other, Others),
    Most is max(1, N//3),
    (   most_letters(Longest),
        N =< Longest,
        length(Others, M),
        abs(N-M) =< Most,
        apart(Letters, Others, Apart0),
        Apart0 =< Most
    ->  Apart = Apart0
    ;   append(Letters, _, Others),
        Apart is Most+1
    ).

%   apart(As, Bs, N): so many steps make Bs of As. A row has, for the letters of
%   As so far, the numbers for Bs cut off after 0, 1, 2, ... letters.

apart(As, Bs, N) :-
    length(Bs, M),
    numlist(0, M, Row),
    rows(As, none, Bs, [], Row, N).

%   rows(As, A0, Bs, Older, Row, N): A0 and Row are the last letter and its row,
%   Older is the row before.

rows([], _, _, _, Row, N) :-
    last(Row, N).
rows([A|As], A0, Bs, Older, Row, N) :-
    Row = [First0|_],
    First is First0+1,
    row(Bs, none, A-A0, Older, Row, First, Rest),
    rows(As, A, Bs, Row, [First|Rest], N).

row([], _, _, _, _, _, []).
row([B|Bs], B0, A-A0, Older, [Before,Above|Row], Left, [N|Rest]) :-
    (   A == B
    ->  N0 = Before
    ;   N0 is min(Before, min(Above, Left))+1
    ),
    (   B0 == none
    ->  N = N0,
        Older1 = Older
    ;   A == B0,
        B == A0
    ->  Older = [Swapped|Older1],
        N is min(N0, Swapped+1)
    ;   N = N0,
        ( Older = [_|Older1] -> true ; Older1 = [] )
    ),
    row(Bs, B, A-A0, Older1, [Above|Row], N, Rest).
