:- module(sg_spelling,
          [ near_words/3                % +Word, +Words, -Near
          ]).
:- use_module(library(lists), [append/3, member/2]).
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
    (   between(0, Most, Apart0),
        apart(Letters, Others, Apart0)
    ->  Apart = Apart0
    ;   append(Letters, _, Others),
        Apart is Most+1
    ).

%   apart(As, Bs, N) is nondet: N steps at most make Bs of As.

apart([], Bs, N) :-
    length(Bs, More),
    More =< N.
apart([A|As], Bs, N) :-
    (   Bs = [A|Bs1]
    ->  apart(As, Bs1, N)
    ;   N > 0,
        N1 is N-1,
        step([A|As], Bs, As1, Bs1),
        apart(As1, Bs1, N1)
    ).

%   step(As0, Bs0, As, Bs) is nondet: what is left of both after a step.

step([_|As], Bs, As, Bs).                       % left out
step(As, [_|Bs], As, Bs).                       % put in
step([_|As], [_|Bs], As, Bs).                   % replaced
step([A,B|As], [B,A|Bs], As, Bs).               % changed places
