using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>One user's session at a station, until sign-out or a period of inactivity. Thread-safe.</summary>
/// <param name="users">The users.</param>
/// <param name="clock">The clock.</param>
/// <param name="idle">The period of inactivity after which the session ends.</param>
/// <param name="ways">How people may sign in besides by password.</param>
public sealed class Session(UserBook users, TimeProvider clock, TimeSpan idle, SignInWays ways)
{
    private readonly Lock _lock = new();
    private SignedIn? _who;
    private long _touched;
    private DateTimeOffset _touchedAt;

    /// <summary>The signed-in user; null if no one is signed in or the session has timed out.</summary>
    public SignedIn? Who
    {
        get
        {
            lock (_lock)
            {
                // By both clocks: one stops while a computer sleeps, the other may be set back.
                if (_who is not null && (clock.GetElapsedTime(_touched) >= idle || clock.GetUtcNow() - _touchedAt >= idle))
                {
                    Leave(Recorded.Idle.With());
                }

                return _who;
            }
        }
    }

    /// <summary>The fewest characters of a badge's code.</summary>
    public const int LeastBadge = Credentials.LeastCharacters;

    /// <summary>How people may sign in besides by password.</summary>
    public SignInWays Ways => ways;

    /// <summary>True if a PIN counts, alone or with a badge.</summary>
    public bool TakesPins => (ways & (SignInWays.Pin | SignInWays.BadgeWithPin)) != SignInWays.Password;

    /// <summary>True if a badge counts, alone or with a PIN.</summary>
    public bool TakesBadges => (ways & (SignInWays.Badge | SignInWays.BadgeWithPin)) != SignInWays.Password;

    /// <summary>Signs a user in, in place of the current one.</summary>
    /// <param name="name">The user.</param>
    /// <param name="secret">The password, or a PIN where the cell accepts PINs.</param>
    /// <exception cref="PeopleException">As for <see cref="UserBook.SignIn"/>; then no one is signed in.</exception>
    public SignedIn SignIn(string name, string secret)
    {
        lock (_lock)
        {
            SignOut();
            _who = Checked(name, secret, null);
            Restart();
            return _who;
        }
    }

    /// <summary>Signs a user in by badge, in place of the current one.</summary>
    /// <param name="code">The badge's code.</param>
    /// <param name="secret">The PIN or password; null where the badge suffices.</param>
    /// <exception cref="PeopleException">As for <see cref="UserBook.SignInByBadge"/>; then no one is signed in.</exception>
    public SignedIn SignInByBadge(string code, string? secret)
    {
        lock (_lock)
        {
            SignOut();
            _who = Checked(code, secret);
            Restart();
            return _who;
        }
    }

    /// <summary>The user whose badge it is, who then signs in with it and a PIN.</summary>
    /// <exception cref="PeopleException">As for <see cref="UserBook.FindBadge"/>, and with <see cref="PeopleError.WayNotAllowed"/> where
    /// badges do not count.</exception>
    public string OwnerOf(string code) => TakesBadges
        ? users.FindBadge(code)
        : throw new PeopleException(PeopleError.WayNotAllowed, "This cell does not take badges: signIn of its configuration says so.");

    /// <summary>Takes the signed-in user's password or PIN again, for one act that must be signed.</summary>
    /// <exception cref="PeopleException">As for <see cref="UserBook.SignIn"/>, and with <see cref="PeopleError.NotSigned"/> if no one is
    /// signed in.</exception>
    public SignedIn SignAgain(string secret)
    {
        lock (_lock)
        {
            var again = Checked(Present().Name, secret, null);
            Restart();
            return again;
        }
    }

    /// <summary>Takes the signed-in user's badge, for one act that must be signed.</summary>
    /// <param name="code">The badge's code.</param>
    /// <param name="secret">The PIN or password; null where the badge suffices.</param>
    /// <exception cref="PeopleException">As for <see cref="UserBook.SignInByBadge"/>, and with <see cref="PeopleError.NotSigned"/> if no
    /// one is signed in, or somebody else.</exception>
    public SignedIn SignAgainByBadge(string code, string? secret)
    {
        lock (_lock)
        {
            var (who, owner) = (Present(), OwnerOf(code));
            if (UserName.Key(owner) != UserName.Key(who.Name))
            {
                throw new PeopleException(PeopleError.NotSigned, $"This is the badge of {owner}, and {who.Name} signs here.");
            }

            var again = Checked(code, secret);
            Restart();
            return again;
        }
    }

    /// <summary>Reports a key press or click. A session that has timed out stays ended.</summary>
    public void Touch()
    {
        lock (_lock)
        {
            if (Who is not null)
            {
                Restart();
            }
        }
    }

    /// <summary>Signs out the current user, if any.</summary>
    public void SignOut()
    {
        lock (_lock)
        {
            if (Who is not null)
            {
                Leave(Recorded.ByHand.With());
            }
        }
    }

    private SignedIn Present() => Who ?? throw new PeopleException(PeopleError.NotSigned, "Nobody is signed in here. Sign in first.");

    private SignedIn Checked(string code, string? secret) =>
        secret is null && ways.HasFlag(SignInWays.Badge) ? users.SignInByBadge(code) : Checked(OwnerOf(code), secret ?? "", code);

    // A PIN is never compared with a password: the one has digits alone, and fewer than the other has characters.
    private SignedIn Checked(string name, string secret, string? badge)
    {
        var isPin = Credentials.IsPin(secret)
            && (ways.HasFlag(SignInWays.Pin) || (badge is not null && ways.HasFlag(SignInWays.BadgeWithPin)));
        return !isPin ? users.SignIn(name, secret)
            : users.SignInByPin(name, secret, ways.HasFlag(SignInWays.Pin) ? null : badge);
    }

    private void Restart() => (_touched, _touchedAt) = (clock.GetTimestamp(), clock.GetUtcNow());

    private void Leave(Statement basis)
    {
        var name = _who!.Name;
        _who = null;
        users.SignedOut(name, basis);
    }
}
