:- module(sg_visitor_upload,
          [ upload_ticket/3,            % +Visitor, +Head, -Ticket
            upload_taken/2,             % +Ticket, -File
            uploads/2,                  % +Visitor, -Names
            visitor_folder/2            % +Visitor, -Folder
          ]).
:- use_module(guard, [new_secret/1, upload_folder/2, upload_name/1]).
:- use_module(request, [request_error/1]).
:- use_module(library(filesex), [make_directory_path/1]).
:- use_module(library(lists), [member/2]).
/** <module> Files that pages send.
*/

% upload_(Ticket, File, Until).
:- dynamic upload_/3.

%   What a visitor may send: so many files, each so many seconds after he was
%   given its ticket.

most(uploads, 20).
most(seconds, 60).

%!  upload_ticket(+Visitor, +Head:dict, -Ticket:string) is det.
%
%   With Ticket the page may send the file Head.name, once.
%
%   @error request_error(too_many_uploads(Most))

upload_ticket(Visitor, Head, Ticket) :-
    ( get_dict(name, Head, Name) -> true ; Name = "" ),
    upload_name(Name),
    uploads(Visitor, Names),
    length(Names, Length),
    most(uploads, Most),
    (   ( Length < Most ; memberchk(Name, Names) )
    ->  true
    ;   request_error(too_many_uploads(Most))
    ),
    visitor_folder(Visitor, Folder),
    make_directory_path(Folder),
    atomic_list_concat([Folder,/,Name], File),
    new_secret(Ticket),
    get_time(Now),
    most(seconds, Seconds),
    Until is Now+Seconds,
    assertz(upload_(Ticket, File, Until)).

%!  visitor_folder(+Visitor, -Folder) is det.
%
%   Folder has what Visitor sent.

visitor_folder(Visitor, Folder) :-
    (   atom_concat('pupil ', Secret, Visitor)
    ->  Owner = pupil(Secret)
    ;   Owner = true
    ),
    upload_folder(Owner, Folder).

%!  upload_taken(+Ticket:string, -File) is semidet.
%
%   With Ticket a page sends File; once.

upload_taken(Ticket, File) :-
    get_time(Now),
    retract(upload_(Ticket, File, Until)),
    Until >= Now,
    !.

%!  uploads(+Visitor, -Names) is det.
%
%   Names of files that Visitor sent.

uploads(Visitor, Names) :-
    visitor_folder(Visitor, Folder),
    catch(directory_files(Folder, Files), error(_, _), Files = []),
    findall(Name,
            ( member(File, Files),
              atom_string(File, Name),
              catch(upload_name(Name), error(_, _), fail) ),
            Names0),
    sort(Names0, Names).
