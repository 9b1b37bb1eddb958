using System.Globalization;

namespace ErrorMatching.Cell;

/// <summary>The users of a cell: who they are, what they may do, and whether it is they who ask. Everything here leaves an entry in the audit trail. Safe for use by several threads.</summary>
/// <remarks>Failures of the store are a <see cref="StoreException"/>.</remarks>
public sealed class UserBook
{
    /// <summary>How long a password is good for the act that it was given for.</summary>
    private static readonly TimeSpan Signing = TimeSpan.FromMinutes(2);

    private readonly CellStore _store;
    private readonly TimeProvider _clock;

    /// <summary>The users of a store.</summary>
    public UserBook(CellStore store, TimeProvider clock)
        : this(store, clock, new PasswordHashes())
    {
    }

    internal UserBook(CellStore store, TimeProvider clock, PasswordHashes hashes) => (_store, _clock, Hashes) = (store, clock, hashes);

    internal PasswordHashes Hashes { get; }

    /// <summary>True if nobody can sign in yet, and the first administrator is to be made by <see cref="AddFirst"/>.</summary>
    public bool IsEmpty => List().Count == 0;

    /// <summary>All users, in the order of their names.</summary>
    public IReadOnlyList<User> List() => _store.Write(t => Person.All(t).Select(p => Known(t, p)).ToArray());

    /// <summary>Makes the first user, an administrator, without anybody's signing: whoever can write the store may do that, as long as it has no user.</summary>
    /// <exception cref="PeopleException">The name is none or the password too weak; with <see cref="PeopleError.NotSigned"/> if there are users.</exception>
    public User AddFirst(string name, string password)
    {
        var hash = HashOf(name, password);
        return _store.Write(t => Person.All(t).Count == 0
            ? Insert(t, "console", name, Role.Administrator, hash, Recorded.FirstAdministrator.With())
            : throw new PeopleException(PeopleError.NotSigned, "This cell has users: an administrator has to sign for another one."));
    }

    /// <summary>Adds a user.</summary>
    /// <param name="by">The administrator who signs.</param>
    /// <param name="name">1 to 64 printable characters; no other user's but for large and small letters.</param>
    /// <param name="role">What the user may do.</param>
    /// <param name="password">12 characters or more.</param>
    /// <exception cref="PeopleException">The user exists, the name is none, the password too weak, or <paramref name="by"/> may not do that.</exception>
    public User Add(SignedIn by, string name, Role role, string password)
    {
        var hash = HashOf(name, password);
        return _store.Write(t =>
        {
            Demand(t, by, Act.ManageUsers);
            return Person.Find(t, name) is { } other
                ? throw new PeopleException(PeopleError.UserExists, $"There is a user {other.Name}. Names that differ in large and small letters only are the same.")
                : Insert(t, by.Name, name, role, hash, Recorded.AsRole.With(Word(role)));
        });
    }

    /// <summary>Keeps a user from signing in. What is signed in is out with the next act.</summary>
    /// <exception cref="PeopleException">There is no such user, it is the last administrator, or <paramref name="by"/> may not do that.</exception>
    public User Disable(SignedIn by, string name) => Change(by, name, "user-disabled", "", p => p with { IsDisabled = true });

    /// <summary>Lets a user sign in again, at once.</summary>
    /// <exception cref="PeopleException">There is no such user, or <paramref name="by"/> may not do that.</exception>
    public User Enable(SignedIn by, string name) => Change(by, name, "user-enabled", "", p => p with { IsDisabled = false }, isUnlocked: true);

    /// <summary>Gives a user another role.</summary>
    /// <exception cref="PeopleException">There is no such user, it is the last administrator, or <paramref name="by"/> may not do that.</exception>
    public User SetRole(SignedIn by, string name, Role role) =>
        Change(by, name, "role-set", Recorded.ToRole.With(Word(role)), p => p.As(role));

    /// <summary>Sets a password: one's own, or as an administrator anybody's, who is unlocked with it.</summary>
    /// <exception cref="PeopleException">There is no such user, the password is too weak, or <paramref name="by"/> may not do that.</exception>
    public User SetPassword(SignedIn by, string name, string password)
    {
        var hash = HashOf(name, password);
        return Change(by, name, "password-set", "", p => p with { Password = hash, PasswordAt = StoredTime.Rounded(_clock.GetUtcNow()) }, isUnlocked: true, isOwnAllowed: true);
    }

    /// <summary>Compares a password. It takes as long for a name that is no user's, and fails with the same words.</summary>
    /// <exception cref="PeopleException">With <see cref="PeopleError.SignInRefused"/>, <see cref="PeopleError.LockedOut"/>, <see cref="PeopleError.UserDisabled"/> (with the right password only) or <see cref="PeopleError.NoUsers"/>.</exception>
    public SignedIn SignIn(string name, string password)
    {
        // A try counts as failed before it is compared: many at once are not more tries than one after another.
        var (person, failures, lockedUntil) = _store.Write(t => BeginTry(t, name));
        if (lockedUntil is { } until)
        {
            throw Refusal(PeopleError.LockedOut, "There were too many failed sign-ins in a row.", until);
        }

        var (isRight, isStale) = Hashes.Compare(person?.Password, password);
        if (person?.Problem is { } problem)
        {
            // Whatever the password is: it is somebody else's, or good for nothing.
            _store.Write(t =>
            {
                t.Audit(person.Name, "sign-in-failed", null, problem.Message);
                return true;
            });
            throw problem;
        }

        if (person is not null && isRight && !person.IsDisabled)
        {
            var fresh = isStale ? Hashes.Of(password) : null;
            return _store.Write(t => EndTry(t, person, fresh));
        }

        lockedUntil = _store.Write(t => Fail(t, person, failures, isRight));
        throw isRight
            ? new PeopleException(PeopleError.UserDisabled, $"The user {person!.Name} is disabled. An administrator can change that: errormatch user enable.")
            : Refusal(PeopleError.SignInRefused, "Name or password is wrong.", lockedUntil);
    }

    /// <summary>Makes sure that who signed in may do something now: is still a user, still has the role, and for what must be signed has just given the password for nothing else.</summary>
    /// <exception cref="PeopleException">With <see cref="PeopleError.NotAllowed"/>, <see cref="PeopleError.UserDisabled"/> or <see cref="PeopleError.NotSigned"/>.</exception>
    public void Demand(SignedIn who, Act act) => _store.Write(t =>
    {
        Demand(t, who, act);
        return who;
    });

    /// <summary>Keeps that somebody left.</summary>
    internal void SignedOut(string name, string basis) => _store.Write(t =>
    {
        t.Audit(name, "signed-out", null, basis);
        return name;
    });

    internal static string Word(Role role) => role.ToString().ToLowerInvariant();

    private static (Person? Person, SignInFailures Failures, DateTimeOffset? LockedUntil) BeginTry(StoreTransaction t, string name)
    {
        var person = Person.Find(t, name);
        if (person is null && Person.All(t).Count == 0)
        {
            throw new PeopleException(PeopleError.NoUsers, "This cell has no users yet. The first is made by errormatch user add CONFIG NAME --role administrator.");
        }

        var failures = SignInFailures.Of(t, name);

        // A clock that was set back must not lock anybody until it is where it was.
        failures = failures.Last > t.Now ? failures with { Last = t.Now } : failures;
        var until = LockOut.Until(failures.Failures, failures.Last, t.Now);
        failures = until is null ? new(failures.Failures + 1, t.Now) : failures;
        failures.Keep(t, name, person is not null);
        return (person, failures, until);
    }

    private SignedIn EndTry(StoreTransaction t, Person tried, string? freshHash)
    {
        var person = Person.Find(t, tried.Name);
        if (person is null || person.Password != tried.Password || person.IsDisabled || person.Problem is not null)
        {
            throw Refusal(PeopleError.SignInRefused, "The user was changed at this moment.", null);
        }

        SignInFailures.Forget(t, person.Name);
        if (freshHash is not null)
        {
            (person with { Password = freshHash }).Update(t);
        }

        t.Audit(person.Name, "signed-in", null, Recorded.SignedIn.With(Word(person.Role!.Value)));
        return new SignedIn(Known(t, person), _clock);
    }

    private static DateTimeOffset? Fail(StoreTransaction t, Person? person, SignInFailures failures, bool isRight)
    {
        var until = LockOut.Until(failures.Failures, failures.Last, failures.Last);
        var strangers = SignInFailures.ForgetStrangers(t);
        if (person is not null)
        {
            var basis = isRight ? Recorded.WrongDisabled.With() : Recorded.WrongPassword.With(failures.Failures);
            t.Audit(person.Name, until is null ? "sign-in-failed" : "locked", null, until is null ? basis : Recorded.UntilUtc.With(basis, until));
        }
        else if (strangers <= SignInFailures.MostStrangersInTrail)
        {
            t.Audit("unknown", "sign-in-failed", null, (strangers < SignInFailures.MostStrangersInTrail ? Recorded.NoSuchName : Recorded.NoSuchNames).With());
        }

        return until;
    }

    private User Change(SignedIn by, string name, string what, string basis, Func<Person, Person> change, bool isUnlocked = false, bool isOwnAllowed = false) => _store.Write(t =>
    {
        if (isOwnAllowed && UserName.Key(by.Name) == UserName.Key(name))
        {
            if (Person.Find(t, name)?.Problem is { } problem) throw problem;
            DemandSigned(by);
        }
        else
        {
            Demand(t, by, Act.ManageUsers);
        }

        var before = Person.Find(t, name) ?? throw new PeopleException(PeopleError.UnknownUser, $"There is no user {name}. errormatch user list CONFIG names them.");
        before = before.IsAsLeft ? before : Mended(t, before);
        var after = change(before);
        if (IsManaging(before) && !IsManaging(after) && Person.All(t).Count(IsManaging) == 1)
        {
            throw new PeopleException(PeopleError.LastAdministrator, $"{before.Name} is the last administrator who may sign in: nobody could manage users any more. Make another administrator first.");
        }

        after.Update(t);
        if (isUnlocked)
        {
            SignInFailures.Forget(t, name);
        }

        t.Audit(by.Name, what, before.Name, basis);
        return Known(t, after);
    });

    private void Demand(StoreTransaction t, SignedIn who, Act act)
    {
        var person = Person.Find(t, who.Name);
        if (person is null or { IsDisabled: true })
        {
            throw new PeopleException(PeopleError.UserDisabled, $"The user {who.Name} was disabled meanwhile.");
        }

        if (person.Problem is { } problem) throw problem;
        if (person.Role is not { } role || !Rights.Allows(role, act))
        {
            throw new PeopleException(PeopleError.NotAllowed, $"{person.Name} is {person.RoleWord.ToLowerInvariant()}, and this takes "
                + $"{Word(Rights.LeastFor(act))}.");
        }

        if (Rights.IsSigned(act))
        {
            DemandSigned(who);
        }
    }

    // Nothing of a row that somebody else wrote is taken over: what is not set now is as the audit trail says, and the password is to be
    // set.
    private Person Mended(StoreTransaction t, Person person) =>
        AuditReplay.Of(t)?.People.GetValueOrDefault(UserName.Key(person.Name)) is { } recorded ? person.Mended(recorded, Hashes.Nobodys)
            : throw new PeopleException(
            PeopleError.Tampered,
            $"The audit trail is not whole, or does not say that {person.Name} was ever added: nobody knows who this user is. See "
                + "errormatch audit verify; then restore a backup.");

    private void DemandSigned(SignedIn who)
    {
        if (!who.Sign(_clock, Signing))
        {
            throw new PeopleException(PeopleError.NotSigned, "This takes a password given for it alone, just now. Sign again.");
        }
    }

    private string HashOf(string name, string password)
    {
        UserName.Demand(name);
        PasswordRule.Demand(name, password);
        return Hashes.Of(password);
    }

    private static User Insert(StoreTransaction t, string by, string name, Role role, string hash, string basis)
    {
        var person = new Person(name, role, hash, IsDisabled: false, t.Now, t.Now);
        person.Insert(t);

        // What was tried under this name before there was such a user is not the user's doing.
        SignInFailures.Forget(t, name);
        t.Audit(by, "user-added", name, basis);
        return Known(t, person);
    }

    private static User Known(StoreTransaction t, Person person)
    {
        var failures = SignInFailures.Of(t, person.Name);
        return new(person.Name, person.Role ?? Role.Operator, person.IsDisabled, person.AddedAt, person.PasswordAt)
        {
            RoleWord = person.RoleWord.ToLowerInvariant(),
            Problem = person.Problem is { } problem ? (problem.Error, problem.Message) : null,
            Failures = failures.Failures,
            LockedUntil = LockOut.Until(failures.Failures, failures.Last > t.Now ? t.Now : failures.Last, t.Now),
        };
    }

    private static bool IsManaging(Person person) => person is { Role: Role.Administrator, IsDisabled: false, IsAsLeft: true };

    private static PeopleException Refusal(PeopleError error, string problem, DateTimeOffset? until)
    {
        var locked = until is null ? "" : string.Create(CultureInfo.InvariantCulture, $" This name is locked until {until:yyyy-MM-dd HH:mm:ss} UTC.");
        return new(error, problem + locked) { LockedUntil = until };
    }
}
