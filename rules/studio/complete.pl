:- module(sg_complete,
          [ completed/4                 % +World, :Names, +Head, -Reply
          ]).
:- use_module('../decision', [decision/4]).
:- use_module('../message/about_ko', [about_ko/2, form_about_ko/2]).
:- use_module('../message/decision_ko', [decision_ko/2]).
:- use_module('../primitive/primitive', [primitive/1, primitive_form/2]).
:- use_module('../spelling', [near_words/3]).
:- use_module('../store', [param/2, relation/3, segment/3]).
:- use_module(world_state, [in_state/3]).
:- use_module(request, [request_error/1]).
:- use_module(library(apply), [maplist/3]).
:- use_module(library(lists), [append/3, member/2, memberchk/2]).
/** <module> What a beginning of a word may become: relations, predicates,
primitives, decisions, requests, and the names of the model.
*/

:- meta_predicate completed(+, 3, +, -).

%   most_words(N): that a reply has.

most_words(50).

%!  completed(+World, :Names, +Head:dict, -Reply:dict) is det.
%
%   Reply has `words`, a list of dicts, of what the text Head.text may become,
%   or what is meant if nothing begins with it; `left` is how many more there
%   are. World is that of the document, or `none`; call(Names, Kind, Word, Doc)
%   is true of each word that is not of this file.
%
%   @error request_error(bad_key(text, text))

completed(World, Names, Head, _{words:Words, left:Left}) :-
    (   get_dict(text, Head, Text),
        string(Text),
        string_length(Text, Length),
        Length =< 200
    ->  true
    ;   request_error(bad_key(text, text))
    ),
    string_lower(Text, Small),
    (   World == none
    ->  Own = []
    ;   in_state(World, loaded,
                 findall(Word, sg_complete:model_word(Word), Own))
    ),
    findall(Word, ( member(Word, Own) ; known_word(Names, Word) ), All0),
    sort(All0, All),
    findall(Rank-Word,
            ( member(Word, All), Word = word(Name, _, _),
              begins(Small, Name, Rank) ),
            Ranked0),
    (   Ranked0 == []
    ->  meant(Text, All, Found)
    ;   keysort(Ranked0, Ranked),
        findall(Word, member(_-Word, Ranked), Found)
    ),
    most_words(Most),
    first_words(Most, Found, First, Left),
    maplist(word_dict, First, Words).

%   begins(Small, Name, Rank): with it 0; one of its words does 1.

begins(Small, Name, Rank) :-
    string_lower(Name, Lower),
    (   sub_string(Lower, 0, _, _, Small)
    ->  Rank = 0
    ;   string_concat("_", Small, Inner),
        sub_string(Lower, _, _, _, Inner)
    ->  Rank = 1
    ).

meant(Text, All, Found) :-
    atom_string(Word, Text),
    findall(Name, ( member(word(Name0, _, _), All), atom_string(Name, Name0) ),
            Names),
    near_words(Word, Names, Near),
    findall(word(Name0, Kind, Doc),
            ( member(Name, Near), atom_string(Name, Name0),
              member(word(Name0, Kind, Doc), All) ),
            Found0),
    sort(Found0, Found).

first_words(Most, Words, First, Left) :-
    length(Words, N),
    Left is max(0, N-Most),
    Taken is min(N, Most),
    length(First, Taken),
    append(First, _, Words).

%   Doc is a text, or a dict of texts in both languages.

word_dict(word(Name, Kind, Doc), _{word:Name, kind:Kind, doc:En, ko:Ko}) :-
    (   is_dict(Doc)
    ->  _{en:En, ko:Ko} :< Doc
    ;   in_korean(Kind, Name, Doc, Ko0)
    ->  En = Doc,
        Ko = Ko0
    ;   En = Doc,
        Ko = Doc
    ).

%   in_korean(Kind, Name, Doc, Ko) is semidet.

in_korean("primitive", _, Form, Ko) :-
    form_about_ko(Form, Ko).
in_korean("decision", Name, _, Ko) :-
    name_arity(Name, Word, Arity),
    decision_ko(Word/Arity, Ko).
in_korean(Kind, Name, _, Ko) :-
    memberchk(Kind, ["relation","predicate"]),
    name_arity(Name, Word, Arity),
    (   about_ko(Word/Arity, Ko)
    ->  true
    ;   about_ko(Word, Ko)
    ->  true
    ).

name_arity(Text, Word, Arity) :-
    split_string(Text, "/", "", [Name,Digits]),
    atom_string(Word, Name),
    number_string(Arity, Digits).

%   known_word(Names, Word), model_word(Word): Word is word(Name, Kind, Doc),
%   texts.

known_word(_, word(Name, "relation", Doc)) :-
    relation(Name0, Arity, Doc),
    indicator(Name0, Arity, Name).
known_word(_, word(Name, "decision", Doc)) :-
    decision(Name0/Arity, Doc, _, _),
    indicator(Name0, Arity, Name).
known_word(_, word(Name, "primitive", Form)) :-
    primitive(Name0),
    primitive_form(Name0, Form0),
    atom_string(Name0, Name),
    atom_string(Form0, Form).
known_word(Names, word(Name, Kind, Doc)) :-
    call(Names, Kind, Name, Doc).

indicator(Name, Arity, Text) :-
    format(string(Text), "~w/~w", [Name,Arity]).

:- public model_word/1.

model_word(word(Name, "segment", Doc)) :-
    segment(S, Kind, Term),
    format(string(Name), "s~d", [S]),
    format(string(Doc), "~w ~W", [Kind, Term, [quoted(true), max_depth(12)]]).
model_word(word(Name, "segment", Doc)) :-
    segment(S, Kind, named(Name0, _)),
    format(string(Name), "~w", [Name0]),
    format(string(Doc), "s~d, ~w", [S,Kind]).
model_word(word(Name, "parameter", Doc)) :-
    param(Name0, Value),
    format(string(Name), "~w", [Name0]),
    format(string(Doc), "~w", [Value]).
