using System.Globalization;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>The users of a cell: their identities, their rights, and their sign-in. Every operation here leaves an entry in the audit
/// trail. Thread-safe.</summary>
/// <remarks>Failures of the store throw a <see cref="StoreException"/>.</remarks>
public sealed class UserBook
{
    /// <summary>How long a password entry is valid for the act that it was made for.</summary>
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

    /// <summary>True if there are no users yet, and <see cref="AddFirst"/> must create the first administrator.</summary>
    public bool IsEmpty => List().Count == 0;

    /// <summary>All users, ordered by name.</summary>
    public IReadOnlyList<User> List() => _store.Write(t => Person.All(t).Select(p => Known(t, p)).ToArray());

    /// <summary>Creates the first user, an administrator, without a signature. Anyone who can write the store may do this while it has no
    /// users.</summary>
    /// <exception cref="PeopleException">The name is not allowed or the password too weak; with <see cref="PeopleError.NotSigned"/> if
    /// there are users.</exception>
    public User AddFirst(string name, string password)
    {
        var hash = HashOf(name, password);
        return _store.Write(t =>
        {
            if (Person.All(t).Count > 0)
            {
                throw new PeopleException(PeopleError.NotSigned, "This cell has users: an administrator has to sign for another one.");
            }

            // If somebody deleted earlier users, their PINs and badges must not let the new ones in.
            t.Execute("DELETE FROM credential");
            return Insert(t, "console", name, Role.Administrator, hash, Recorded.FirstAdministrator.With());
        });
    }

    /// <summary>Adds a user.</summary>
    /// <param name="by">The administrator who signs.</param>
    /// <param name="name">1 to 64 printable characters; unique, ignoring case.</param>
    /// <param name="role">The user's role.</param>
    /// <param name="password">12 characters or more.</param>
    /// <exception cref="PeopleException">The user exists, the name is not allowed, the password is too weak, or <paramref name="by"/> does
    /// not have the right.</exception>
    public User Add(SignedIn by, string name, Role role, string password)
    {
        var hash = HashOf(name, password);
        return _store.Write(t =>
        {
            Demand(t, by, Act.ManageUsers);
            return Person.Find(t, name) is { } other
                ? throw new PeopleException(
                    PeopleError.UserExists,
                    $"There is a user {other.Name}. Names that differ in large and small letters only are the same.")
                : Insert(t, by.Name, name, role, hash, Recorded.AsRole.With(Word(role)));
        });
    }

    /// <summary>Prevents a user from signing in. A session in progress ends with its next act.</summary>
    /// <exception cref="PeopleException">There is no such user, it is the last administrator, or <paramref name="by"/> does not have the
    /// right.</exception>
    public User Disable(SignedIn by, string name) => Change(by, name, "user-disabled", "", (_, p) => p with { IsDisabled = true });

    /// <summary>Lets a user sign in again, immediately.</summary>
    /// <exception cref="PeopleException">There is no such user, or <paramref name="by"/> does not have the right.</exception>
    public User Enable(SignedIn by, string name) =>
        Change(by, name, "user-enabled", "", (_, p) => p with { IsDisabled = false }, isUnlocked: true);

    /// <summary>Gives a user another role.</summary>
    /// <exception cref="PeopleException">There is no such user, it is the last administrator, or <paramref name="by"/> does not have the
    /// right.</exception>
    public User SetRole(SignedIn by, string name, Role role) =>
        Change(by, name, "role-set", Recorded.ToRole.With(Word(role)), (_, p) => p.As(role));

    /// <summary>Sets a password: the user's own, or, as an administrator, anyone's. This also unlocks the user.</summary>
    /// <exception cref="PeopleException">There is no such user, the password is too weak, or <paramref name="by"/> does not have the
    /// right.</exception>
    public User SetPassword(SignedIn by, string name, string password)
    {
        var hash = HashOf(name, password);
        return Change(
            by,
            name,
            "password-set",
            "",
            (_, p) => p with { Password = hash, PasswordAt = StoredTime.Rounded(_clock.GetUtcNow()) },
            isUnlocked: true,
            isOwnAllowed: true);
    }

    /// <summary>Sets a PIN: the user's own, or, as an administrator, anyone's.</summary>
    /// <param name="by">Who signs, with a password.</param>
    /// <param name="name">The user.</param>
    /// <param name="pin">6 to 8 digits.</param>
    /// <exception cref="PeopleException">There is no such user, the PIN is too easy to guess, or <paramref name="by"/> does not have the
    /// right.</exception>
    public User SetPin(SignedIn by, string name, string pin)
    {
        Credentials.DemandPin(pin);
        return Change(
            by,
            name,
            "pin-set",
            "",
            (t, p) => Put(t, p, CredentialKind.Pin, Hashes.Of(Credentials.PinSecret(KeyOf(t), p.Name, pin))),
            isOwnAllowed: true);
    }

    /// <summary>Takes a PIN away: the user's own, or, as an administrator, anyone's.</summary>
    /// <exception cref="PeopleException">There is no such user, or <paramref name="by"/> does not have the right.</exception>
    public User RemovePin(SignedIn by, string name) =>
        Change(by, name, "pin-removed", "", (t, p) => Put(t, p, CredentialKind.Pin, ""), isOwnAllowed: true);

    /// <summary>Binds a badge to a user, in place of an earlier one.</summary>
    /// <param name="by">The administrator who signs.</param>
    /// <param name="name">The user.</param>
    /// <param name="code">The code that a scanner reads from the badge.</param>
    /// <exception cref="PeopleException">There is no such user, the badge is another user's or its code is too short, or
    /// <paramref name="by"/> does not have the right.</exception>
    public User SetBadge(SignedIn by, string name, string code)
    {
        Credentials.DemandBadge(code);
        return Change(by, name, "badge-set", "", (t, p) =>
        {
            var hash = Credentials.BadgeHash(KeyOf(t), code);
            if (CredentialRow.FindBadge(t, hash) is { } other && other.NameKey != UserName.Key(p.Name))
            {
                throw new PeopleException(
                    PeopleError.BadgeTaken,
                    $"This badge belongs to {Person.Find(t, other.NameKey)?.Name ?? other.NameKey}. Take it away there first: errormatch "
                        + "user badge.");
            }

            return Put(t, p, CredentialKind.Badge, hash);
        });
    }

    /// <summary>Takes a badge away from a user.</summary>
    /// <exception cref="PeopleException">There is no such user, or <paramref name="by"/> does not have the right.</exception>
    public User RemoveBadge(SignedIn by, string name) =>
        Change(by, name, "badge-removed", "", (t, p) => Put(t, p, CredentialKind.Badge, ""));

    /// <summary>The user whose badge it is, for a sign-in by badge and PIN: the badge alone proves nothing.</summary>
    /// <returns>The user's name.</returns>
    /// <exception cref="PeopleException">As for <see cref="SignInByBadge"/>.</exception>
    public string FindBadge(string code)
    {
        var (person, failures, lockedUntil) = _store.Write(t => BeginTry(t, code, KeyOf(t)));
        return person?.Name ?? throw RefusedBadge(failures, lockedUntil);
    }

    /// <summary>True if a code is somebody's badge. It counts as no attempt, so that codes of pieces can be told from badges.</summary>
    /// <exception cref="PeopleException">With <see cref="PeopleError.Tampered"/>.</exception>
    public bool IsBadge(string code) => _store.Write(t => CredentialRow.FindBadge(t, Credentials.BadgeHash(KeyOf(t), code)) is not null);

    /// <summary>Signs in by badge alone.</summary>
    /// <exception cref="PeopleException">With <see cref="PeopleError.SignInRefused"/>, <see cref="PeopleError.LockedOut"/> after too many
    /// badges of nobody, <see cref="PeopleError.UserDisabled"/> or <see cref="PeopleError.Tampered"/>.</exception>
    public SignedIn SignInByBadge(string code)
    {
        var (person, failures, lockedUntil) = _store.Write(t => BeginTry(t, code, KeyOf(t)));
        if (person is null)
        {
            throw RefusedBadge(failures, lockedUntil);
        }

        if (person.Problem is { } problem) throw problem;
        return !person.IsDisabled
            ? _store.Write(t => EndTry(t, person, null, null, Recorded.SignedInByBadge))
            : throw Disabled(person);
    }

    /// <summary>Checks a PIN. An unknown name, or a user without a PIN, takes just as long and fails with the same message.</summary>
    /// <param name="name">The user.</param>
    /// <param name="pin">The PIN.</param>
    /// <param name="badge">The badge's code if the PIN counts only with it; null if it counts alone.</param>
    /// <exception cref="PeopleException">As for <see cref="SignIn"/>: a wrong PIN counts as a wrong password does.</exception>
    public SignedIn SignInByPin(string name, string pin, string? badge)
    {
        var (person, failures, lockedUntil) = _store.Write(t => BeginTry(t, name));
        var (key, stored) = _store.Write(t => (KeyOf(t), person is null ? null : CredentialRow.Find(t, person.Name, CredentialKind.Pin)));
        return Compared(
            person,
            failures,
            lockedUntil,
            (stored?.Hash, Credentials.PinSecret(key, name, pin)),
            stored,
            badge is null ? Recorded.SignedInByPin : Recorded.SignedInByBadgeAndPin,
            Recorded.WrongPin,
            badge);
    }

    /// <summary>Checks a password. An unknown name takes just as long and fails with the same message.</summary>
    /// <exception cref="PeopleException">With <see cref="PeopleError.SignInRefused"/>, <see cref="PeopleError.LockedOut"/>,
    /// <see cref="PeopleError.UserDisabled"/> (with the right password only) or <see cref="PeopleError.NoUsers"/>.</exception>
    public SignedIn SignIn(string name, string password)
    {
        var (person, failures, lockedUntil) = _store.Write(t => BeginTry(t, name));
        return Compared(
            person, failures, lockedUntil, (person?.Password, password), null, Recorded.SignedIn, Recorded.WrongPassword, null);
    }

    // What is typed is a password, or, with a stored one, a PIN.
    private SignedIn Compared(
        Person? person,
        SignInFailures failures,
        DateTimeOffset? lockedUntil,
        (string? Hash, string Typed) compared,
        CredentialRow? pin,
        SentenceForm how,
        SentenceForm wrong,
        string? badge)
    {
        if (lockedUntil is { } until)
        {
            throw Refusal(PeopleError.LockedOut, "There were too many failed sign-ins in a row.", until);
        }

        var (isRight, isStale) = Hashes.Compare(compared.Hash, compared.Typed);
        if (person?.Problem is { } problem)
        {
            // Regardless of the password: the row is not the cell's, or its role is unknown.
            _store.Write(t =>
            {
                t.Audit(person.Name, "sign-in-failed", null, problem.Statement);
                return true;
            });
            throw problem;
        }

        if (person is not null && isRight && !person.IsDisabled)
        {
            var fresh = isStale ? Hashes.Of(compared.Typed) : null;
            return _store.Write(t =>
            {
                // The badge is still this user's: it was looked up before the PIN was typed.
                if (badge is not null
                    && CredentialRow.FindBadge(t, Credentials.BadgeHash(KeyOf(t), badge))?.NameKey != UserName.Key(person.Name))
                {
                    throw Refusal(PeopleError.SignInRefused, "The user was changed at this moment.", null);
                }

                return EndTry(t, person, pin, fresh, how);
            });
        }

        lockedUntil = _store.Write(t => Fail(t, person, failures, isRight, wrong));
        throw isRight ? Disabled(person!) : Refusal(PeopleError.SignInRefused, "Name or password is wrong.", lockedUntil);
    }

    /// <summary>Ensures that the signed-in user may do something now: the user still exists and still has the role, and for an act that
    /// must be signed has just given the password for this act alone.</summary>
    /// <exception cref="PeopleException">With <see cref="PeopleError.NotAllowed"/>, <see cref="PeopleError.UserDisabled"/> or
    /// <see cref="PeopleError.NotSigned"/>.</exception>
    public void Demand(SignedIn who, Act act) => _store.Write(t =>
    {
        Demand(t, who, act);
        return who;
    });

    /// <summary>Records a sign-out.</summary>
    internal void SignedOut(string name, Statement basis) => _store.Write(t =>
    {
        t.Audit(name, "signed-out", null, basis);
        return name;
    });

    private static Person? Put(StoreTransaction t, Person person, CredentialKind kind, string hash)
    {
        new CredentialRow(UserName.Key(person.Name), kind, hash, t.Now).Put(t);
        return null;
    }

    private static string Word(Role role) => Rights.Word(role);

    private static (Person? Person, SignInFailures Failures, DateTimeOffset? LockedUntil) BeginTry(StoreTransaction t, string name)
    {
        var person = Person.Find(t, name);
        if (person is null && Person.All(t).Count == 0)
        {
            throw new PeopleException(
                PeopleError.NoUsers,
                "This cell has no users yet. The first is made by errormatch user add CONFIG NAME --role administrator.");
        }

        // An attempt counts as failed before the comparison, so many parallel attempts gain nothing over sequential ones.
        var failures = person is null ? SignInFailures.Of(t, name) : SignInFailures.Of(t, person);

        // A clock that was set back must not keep a lock until the earlier time is reached again.
        failures = failures.Last > t.Now ? failures with { Last = t.Now } : failures;
        var until = LockOut.Until(failures.Failures, failures.Last, t.Now);
        failures = until is null ? new(failures.Failures + 1, t.Now) : failures;
        failures.Keep(t, name, person is not null);
        return (person, failures, until);
    }

    // A badge is looked up, not compared: only badges of nobody count, and all together, because there is no name to lock.
    private static (Person? Person, SignInFailures Failures, DateTimeOffset? LockedUntil) BeginTry(
        StoreTransaction t, string code, byte[] key)
    {
        var failures = SignInFailures.Of(t, Credentials.AllBadges);
        failures = failures.Last > t.Now ? failures with { Last = t.Now } : failures;
        failures = t.Now - failures.Last >= Credentials.BadgeMemory ? failures with { Failures = 0 } : failures;
        if (LockOut.Until(failures.Failures, failures.Last, t.Now) is { } until)
        {
            return (null, failures, until);
        }

        if (CredentialRow.FindBadge(t, Credentials.BadgeHash(key, code)) is { } badge && Person.Find(t, badge.NameKey) is { } person)
        {
            return (person, failures, null);
        }

        failures = new(failures.Failures + 1, t.Now);
        failures.Keep(t, Credentials.AllBadges, isUser: true);
        var locked = LockOut.Until(failures.Failures, failures.Last, t.Now);
        var basis = Recorded.NoSuchBadge.With(failures.Failures);
        t.Audit("unknown", "sign-in-failed", null, locked is null ? basis : Recorded.UntilUtc.With(basis, locked));
        return (null, failures, null);
    }

    private static PeopleException RefusedBadge(SignInFailures failures, DateTimeOffset? lockedUntil) => lockedUntil is { } until
        ? Refusal(PeopleError.LockedOut, "There were too many badges of nobody in a row.", until)
        : Refusal(
            PeopleError.SignInRefused,
            "This badge belongs to nobody here.",
            LockOut.Until(failures.Failures, failures.Last, failures.Last));

    private static PeopleException Disabled(Person person) => new(
        PeopleError.UserDisabled, $"The user {person.Name} is disabled. An administrator can change that: errormatch user enable.");

    private SignedIn EndTry(StoreTransaction t, Person tried, CredentialRow? pin, string? freshHash, SentenceForm how)
    {
        var person = Person.Find(t, tried.Name);
        if (person is null
            || person.Password != tried.Password
            || (pin is not null && CredentialRow.Find(t, tried.Name, CredentialKind.Pin)?.Hash != pin.Hash)
            || person.IsDisabled
            || person.Problem is not null)
        {
            throw Refusal(PeopleError.SignInRefused, "The user was changed at this moment.", null);
        }

        // A good badge does not reset the count of unknown ones: otherwise its owner could guess at other people's without a lock.
        if (how != Recorded.SignedInByBadge)
        {
            SignInFailures.Forget(t, person.Name);
        }

        if (freshHash is not null && pin is not null)
        {
            (pin with { Hash = freshHash }).Put(t);
        }
        else if (freshHash is not null)
        {
            (person with { Password = freshHash }).Update(t);
        }

        t.Audit(person.Name, "signed-in", null, how.With(Word(person.Role!.Value)));
        return new SignedIn(Known(t, person), _clock);
    }

    private static DateTimeOffset? Fail(
        StoreTransaction t, Person? person, SignInFailures failures, bool isRight, SentenceForm wrong)
    {
        var until = LockOut.Until(failures.Failures, failures.Last, failures.Last);
        var strangers = SignInFailures.ForgetStrangers(t);
        if (person is not null)
        {
            var basis = isRight ? Recorded.WrongDisabled.With() : wrong.With(failures.Failures);
            t.Audit(
                person.Name,
                until is null ? "sign-in-failed" : "locked",
                null,
                until is null ? basis : Recorded.UntilUtc.With(basis, until));
        }
        else if (strangers <= SignInFailures.MostStrangersInTrail)
        {
            t.Audit(
                "unknown",
                "sign-in-failed",
                null,
                (strangers < SignInFailures.MostStrangersInTrail ? Recorded.NoSuchName : Recorded.NoSuchNames).With());
        }

        return until;
    }

    // A PIN or badge has a row of its own, which the change puts: then the person's row stays as it is.
    private User Change(
        SignedIn by,
        string name,
        string what,
        Statement basis,
        Func<StoreTransaction, Person, Person?> change,
        bool isUnlocked = false,
        bool isOwnAllowed = false) => _store.Write(t =>
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

        var before = Person.Find(t, name)
            ?? throw new PeopleException(PeopleError.UnknownUser, $"There is no user {name}. errormatch user list CONFIG names them.");
        before = before.IsAsLeft ? before : Mended(t, before);
        var changed = change(t, before);
        var after = changed ?? before;
        if (IsManaging(before) && !IsManaging(after) && Person.All(t).Count(IsManaging) == 1)
        {
            throw new PeopleException(
                PeopleError.LastAdministrator,
                $"{before.Name} is the last administrator who may sign in: nobody could manage users any more. Make another "
                    + $"administrator first.");
        }

        changed?.Update(t);
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

    // Nothing is taken from a row that was changed outside the cell: what is not set now comes from the audit trail, and the password must
    // be set again.
    private Person Mended(StoreTransaction t, Person person) =>
        AuditReplay.Of(t)?.People.GetValueOrDefault(UserName.Key(person.Name)) is { } recorded
            ? person.Mended(recorded.Name, recorded.Role, recorded.IsDisabled, Hashes.Nobodys)
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

    private static User Insert(StoreTransaction t, string by, string name, Role role, string hash, Statement basis)
    {
        var person = new Person(name, role, hash, IsDisabled: false, t.Now, t.Now);
        person.Insert(t);

        // Attempts under this name before the user existed do not count against the user.
        SignInFailures.Forget(t, name);
        t.Audit(by, "user-added", name, basis);
        return Known(t, person);
    }

    private static User Known(StoreTransaction t, Person person)
    {
        var failures = SignInFailures.Of(t, person);
        return new(person.Name, person.Role ?? Role.Operator, person.IsDisabled, person.AddedAt, person.PasswordAt)
        {
            RoleWord = person.RoleWord.ToLowerInvariant(),
            Problem = person.Problem is { } problem ? (problem.Error, problem.Message) : null,
            HasPin = HasCredential(t, person, CredentialKind.Pin),
            HasBadge = HasCredential(t, person, CredentialKind.Badge),
            Failures = failures.Failures,
            LockedUntil = LockOut.Until(failures.Failures, failures.Last > t.Now ? t.Now : failures.Last, t.Now),
        };
    }

    private static bool HasCredential(StoreTransaction t, Person person, CredentialKind kind) => t.Value<long>(
        "SELECT count(*) FROM credential WHERE name_key = @Key AND kind = @Kind AND hash <> ''",
        [("Key", UserName.Key(person.Name)), ("Kind", CredentialRow.Word(kind))]) > 0;

    private static byte[] KeyOf(StoreTransaction t) => t.Key ?? throw new PeopleException(
        PeopleError.KeysMissing, "PINs and badges need the key of the audit trail, and this store was opened without it.");

    private static bool IsManaging(Person person) => person is { Role: Role.Administrator, IsDisabled: false, IsAsLeft: true };

    private static PeopleException Refusal(PeopleError error, string problem, DateTimeOffset? until)
    {
        var locked = until is null
            ? ""
            : string.Create(CultureInfo.InvariantCulture, $" This name is locked until {until:yyyy-MM-dd HH:mm:ss} UTC.");
        return new(error, problem + locked) { LockedUntil = until };
    }
}

/// <summary>How long a name is locked after consecutive failed sign-ins: at first not at all, then longer and longer.</summary>
internal static class LockOut
{
    /// <summary>Number of failures without a lock.</summary>
    public const int FreeFailures = 4;

    private static readonly TimeSpan First = TimeSpan.FromSeconds(30);
    private static readonly TimeSpan Longest = TimeSpan.FromHours(1);

    /// <summary>How long the name is locked after the given number of failures: 30 s after the fifth, doubled with each further one, at
    /// most 1 h.</summary>
    public static TimeSpan After(int failures) =>
        failures <= FreeFailures
            ? TimeSpan.Zero
            : failures - FreeFailures - 1 > 7
            ? Longest
            : Min(First * (1 << (failures - FreeFailures - 1)), Longest);

    /// <summary>When the lock ends; null if the name is not locked. Setting the clock back does not make the lock longer.</summary>
    /// <param name="failures">Consecutive failures.</param>
    /// <param name="last">Time of the last failure, by the clock at that time.</param>
    /// <param name="now">The current time.</param>
    public static DateTimeOffset? Until(int failures, DateTimeOffset last, DateTimeOffset now)
    {
        var length = After(failures);
        var until = (last > now ? now : last) + length;
        return length > TimeSpan.Zero && until > now ? until : null;
    }

    private static TimeSpan Min(TimeSpan a, TimeSpan b) => a < b ? a : b;
}
