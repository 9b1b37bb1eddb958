using System.CommandLine;
using ErrorMatching.Cell;

namespace ErrorMatching.Console;

/// <summary>A verb that changes one user.</summary>
internal abstract class UserVerb : SigningVerb
{
    private readonly Argument<string> _name = new("NAME") { Description = "The user." };

    /// <summary>A verb with a user's name.</summary>
    protected UserVerb(string name, string description, string example, string lines = "the password of who signs")
        : base(name, description, example, lines) => Arguments.Add(_name);

    protected sealed override VerbResult Run(CellSettings settings, ParseResult arguments, CancellationToken cancellation)
    {
        if (MayBeFirst)
        {
            StoreFolder.Make(settings);
        }
        else
        {
            DemandStore(settings);
        }

        return WithStore(settings, store => Run(new UserBook(store, TimeProvider.System), arguments.GetRequiredValue(_name), arguments));
    }

    /// <summary>True if the store need not exist yet.</summary>
    protected virtual bool MayBeFirst => false;

    /// <summary>Changes the user.</summary>
    protected abstract VerbResult Run(UserBook users, string name, ParseResult arguments);

    /// <summary>The answer for a changed user.</summary>
    protected UserAnswer Answer(User user, Func<User, string> sentence) => new($"errormatch/user-{Name}/1", user, sentence(user));
}

/// <summary><c>errormatch user add</c>.</summary>
internal sealed class UserAdd : UserVerb
{
    private readonly RoleOption _role = new();

    public UserAdd()
        : base(
            "add",
            "Adds a user. An administrator signs; the first user is an administrator and needs nobody's signature.",
            "errormatch user add samples/cell/cell.json anna --role administrator",
            "the password of who signs (not for the first user), then the new user's") => Options.Add(_role);

    protected override bool MayBeFirst => true;

    protected override VerbResult Run(UserBook users, string name, ParseResult arguments)
    {
        var role = _role.Of(arguments);
        if (!users.IsEmpty)
        {
            var by = Sign(users, arguments);
            return Answer(
                users.Add(by, name, role, AskNew($"new password of {name}", arguments)),
                u => $"{u.Name} is a user now, as {RoleOption.Word(u.Role)}.");
        }

        return role == Role.Administrator
            ? Answer(
                users.AddFirst(name, AskNew($"new password of {name}", arguments)),
                u => $"{u.Name} is the first administrator. Add a second one soon: a lost password is set by another administrator.")
            : throw new PeopleException(
                PeopleError.NoUsers, $"The first user of a cell is an administrator: name --role {RoleOption.Word(Role.Administrator)}.");
    }
}

/// <summary><c>errormatch user disable</c>.</summary>
internal sealed class UserDisable()
    : UserVerb(
        "disable",
        "Keeps a user from signing in. An administrator signs.",
        "errormatch user disable samples/cell/cell.json ben --user anna")
{
    protected override VerbResult Run(UserBook users, string name, ParseResult arguments) =>
        Answer(users.Disable(Sign(users, arguments), name), u => $"{u.Name} may not sign in any more.");
}

/// <summary><c>errormatch user enable</c>.</summary>
internal sealed class UserEnable()
    : UserVerb(
        "enable",
        "Lets a user sign in again, and unlocks the name. An administrator signs.",
        "errormatch user enable samples/cell/cell.json ben --user anna")
{
    protected override VerbResult Run(UserBook users, string name, ParseResult arguments) =>
        Answer(users.Enable(Sign(users, arguments), name), u => $"{u.Name} may sign in.");
}

/// <summary><c>errormatch user password</c>.</summary>
internal sealed class UserPassword() : UserVerb(
    "password",
    "Sets a password: one's own, or as an administrator anybody's.",
    "errormatch user password samples/cell/cell.json anna --user anna",
    "the password of who signs, then the new one")
{
    protected override VerbResult Run(UserBook users, string name, ParseResult arguments)
    {
        var by = Sign(users, arguments);
        return Answer(users.SetPassword(by, name, AskNew($"new password of {name}", arguments)), u => $"{u.Name} has a new password.");
    }
}

/// <summary>A verb that sets what a user signs in with at a station besides a password, or takes it away.</summary>
internal abstract class CredentialVerb : UserVerb
{
    private readonly Option<bool> _remove;

    protected CredentialVerb(string name, string description, string example, string what)
        : base(name, description, example, $"the password of who signs, then the {what} (not with --remove)")
    {
        _remove = new("--remove") { Description = $"Take the {what} away.", Arity = ArgumentArity.Zero };
        Options.Add(_remove);
    }

    protected sealed override VerbResult Run(UserBook users, string name, ParseResult arguments)
    {
        var by = Sign(users, arguments);
        return arguments.GetValue(_remove) ? Remove(users, by, name) : Set(users, by, name, arguments);
    }

    protected abstract VerbResult Set(UserBook users, SignedIn by, string name, ParseResult arguments);

    protected abstract VerbResult Remove(UserBook users, SignedIn by, string name);
}

/// <summary><c>errormatch user pin</c>.</summary>
internal sealed class UserPin() : CredentialVerb(
    "pin",
    "Sets a PIN for stations: one's own, or as an administrator anybody's.",
    "errormatch user pin samples/cell/cell.json anna --user anna",
    "PIN")
{
    protected override VerbResult Set(UserBook users, SignedIn by, string name, ParseResult arguments) =>
        Answer(users.SetPin(by, name, AskNew($"new PIN of {name}", arguments)), u => $"{u.Name} has a new PIN.");

    protected override VerbResult Remove(UserBook users, SignedIn by, string name) =>
        Answer(users.RemovePin(by, name), u => $"{u.Name} has no PIN.");
}

/// <summary><c>errormatch user badge</c>.</summary>
internal sealed class UserBadge() : CredentialVerb(
    "badge",
    "Binds a badge to a user, for stations. An administrator signs.",
    "errormatch user badge samples/cell/cell.json ben --user anna",
    "code of the badge")
{
    protected override VerbResult Set(UserBook users, SignedIn by, string name, ParseResult arguments) =>
        Answer(users.SetBadge(by, name, AskNew($"badge of {name}", arguments)), u => $"The badge belongs to {u.Name} now.");

    protected override VerbResult Remove(UserBook users, SignedIn by, string name) =>
        Answer(users.RemoveBadge(by, name), u => $"{u.Name} has no badge.");
}

/// <summary><c>errormatch user role</c>.</summary>
internal sealed class UserRole : UserVerb
{
    private readonly RoleOption _role = new();

    public UserRole()
        : base(
            "role",
            "Gives a user another role. An administrator signs.",
            "errormatch user role samples/cell/cell.json ben --role setter --user anna") =>
            Options.Add(_role);

    protected override VerbResult Run(UserBook users, string name, ParseResult arguments) =>
        Answer(users.SetRole(Sign(users, arguments), name, _role.Of(arguments)), u => $"{u.Name} is {RoleOption.Word(u.Role)} now.");
}

/// <summary><c>errormatch user list</c>.</summary>
internal sealed class UserList() : CellVerb("list", "Lists the users and what they may do.", "errormatch user list samples/cell/cell.json")
{
    protected override VerbResult Run(CellSettings settings, ParseResult arguments, CancellationToken cancellation) =>
        WithExistingStore(settings, store => new UserListAnswer(new UserBook(store, TimeProvider.System).List()));
}
