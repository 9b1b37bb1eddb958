namespace ErrorMatching.Cell.Tests;

/// <summary>PINs and badges: who has one signs in where the cell accepts it, and nowhere else.</summary>
public sealed class CredentialTests : PeopleTest
{
    private const string Pin = "502817", OtherPin = "971344", Badge = "0004728193", OtherBadge = "0004728194";
    private const SignInWays All = SignInWays.Pin | SignInWays.Badge | SignInWays.BadgeWithPin;

    public CredentialTests() => Users.Add(Anna(), "Ben", Role.Setter, Other);

    [Theory]
    [InlineData(SignInWays.Password, false, false, false)]
    [InlineData(SignInWays.Pin, true, false, false)]
    [InlineData(SignInWays.Badge, false, true, false)]
    [InlineData(SignInWays.BadgeWithPin, false, false, true)]
    [InlineData(SignInWays.Badge | SignInWays.BadgeWithPin, false, true, true)]
    [InlineData(SignInWays.Pin | SignInWays.Badge, true, true, true)]
    public void Each_way_counts_only_where_the_cell_accepts_it(SignInWays ways, bool isPin, bool isBadge, bool isBoth)
    {
        Users.SetPin(Anna(), "Ben", Pin);
        Users.SetBadge(Anna(), "Ben", Badge);
        var session = new Session(Users, Clock, TimeSpan.FromMinutes(10), ways);
        Assert.Equal("Ben", session.SignIn("ben", Other).Name);
        Counts(isPin, () => session.SignIn("ben", Pin));
        Counts(isBadge, () => session.SignInByBadge(Badge, null));
        Counts(isBoth, () => session.SignInByBadge(Badge, Pin));

        void Counts(bool does, Func<SignedIn> signIn)
        {
            if (does)
            {
                Assert.Equal(("Ben", Role.Setter), signIn() is var who ? (who.Name, who.Role) : default);
                Assert.Equal("Ben", session.Who?.Name);
            }
            else
            {
                Assert.Throws<PeopleException>(signIn);
                Assert.Null(session.Who);
            }
        }
    }

    [Fact]
    public void The_trail_says_how_somebody_signed_in_and_who_set_what()
    {
        Users.SetPin(Anna(), "Ben", Pin);
        Assert.Equal("Anna pin-set Ben", Trail[^1]);
        Users.SetBadge(Anna(), "Ben", Badge);
        Assert.Equal("Anna badge-set Ben", Trail[^1]);
        Users.SignInByPin("ben", Pin, null);
        Assert.Equal("Ben signed-in signed-in-by-pin(setter)", Trail[^1]);
        Users.SignInByBadge(Badge);
        Assert.Equal("Ben signed-in signed-in-by-badge(setter)", Trail[^1]);
        Users.SignInByPin("ben", Pin, Badge);
        Assert.Equal("Ben signed-in signed-in-by-badge-and-pin(setter)", Trail[^1]);
        Users.RemovePin(Users.SignIn("Ben", Other), "Ben");
        Assert.Equal("Ben pin-removed Ben", Trail[^1]);
        Users.RemoveBadge(Anna(), "Ben");
        Assert.Equal("Anna badge-removed Ben", Trail[^1]);
        Assert.True(new AuditTrail(Store, Keys).Verify().Holds, new AuditTrail(Store, Keys).Verify().Message);
        Assert.Empty(Store.Tampered());
    }

    [Fact]
    public void A_user_has_what_was_set_until_it_is_taken_away_or_replaced()
    {
        Assert.Equal((false, false), (Users.List()[1].HasPin, Users.List()[1].HasBadge));
        Users.SetPin(Anna(), "Ben", OtherPin);
        Users.SetPin(Anna(), "Ben", Pin);
        Users.SetBadge(Anna(), "Ben", OtherBadge);
        Assert.Equal((true, true), Users.SetBadge(Anna(), "Ben", Badge) is var ben ? (ben.HasPin, ben.HasBadge) : default);
        Refused(PeopleError.SignInRefused, () => Users.SignInByPin("Ben", OtherPin, null));
        Refused(PeopleError.SignInRefused, () => Users.SignInByBadge(OtherBadge));
        Users.SignInByPin("Ben", Pin, null);
        Users.SignInByBadge(Badge);
        Users.RemovePin(Anna(), "Ben");
        Assert.Equal((false, false), Users.RemoveBadge(Anna(), "Ben") is var bare ? (bare.HasPin, bare.HasBadge) : default);
        Refused(PeopleError.SignInRefused, () => Users.SignInByPin("Ben", Pin, null));
        Refused(PeopleError.SignInRefused, () => Users.SignInByBadge(Badge));
        Users.SetBadge(Anna(), "Anna", Badge);
        Assert.Equal("Anna", Users.SignInByBadge(Badge).Name);
    }

    [Fact]
    public void A_badge_belongs_to_one_person()
    {
        Users.SetBadge(Anna(), "Anna", Badge);
        var refusal = Refused(PeopleError.BadgeTaken, () => Users.SetBadge(Anna(), "Ben", Badge));
        Assert.Contains("Anna", refusal.Message, StringComparison.Ordinal);
        Users.SetBadge(Anna(), "Anna", Badge);
    }

    [Fact]
    public void Only_administrators_bind_badges_and_everybody_sets_the_own_PIN()
    {
        Refused(PeopleError.NotAllowed, () => Users.SetBadge(Users.SignIn("Ben", Other), "Ben", Badge));
        Refused(PeopleError.NotAllowed, () => Users.RemoveBadge(Users.SignIn("Ben", Other), "Ben"));
        Refused(PeopleError.NotAllowed, () => Users.SetPin(Users.SignIn("Ben", Other), "Anna", Pin));
        Refused(PeopleError.NotAllowed, () => Users.RemovePin(Users.SignIn("Ben", Other), "Anna"));
        Assert.True(Users.SetPin(Users.SignIn("Ben", Other), "Ben", Pin).HasPin);
        Refused(PeopleError.UnknownUser, () => Users.SetPin(Anna(), "Eve", Pin));

        // One signature, one act.
        var by = Anna();
        Users.SetPin(by, "Ben", OtherPin);
        Refused(PeopleError.NotSigned, () => Users.SetBadge(by, "Ben", Badge));
    }

    [Theory]
    [InlineData("12345"), InlineData("123456789"), InlineData("123456"), InlineData("987654"), InlineData("111111")]
    [InlineData("121212"), InlineData("123123"), InlineData("50281a"), InlineData("５０２８１７"), InlineData("")]
    public void A_PIN_that_is_guessed_first_is_refused(string pin) =>
        Refused(PeopleError.WeakPin, () => Users.SetPin(Anna(), "Ben", pin));

    [Theory]
    [InlineData("12345"), InlineData(" 123456"), InlineData("12345\u0007"), InlineData("")]
    public void A_code_that_no_scanner_sends_is_refused(string code) =>
        Refused(PeopleError.BadBadge, () => Users.SetBadge(Anna(), "Ben", code));

    [Fact]
    public void Wrong_PINs_lock_the_name_as_wrong_passwords_do_and_both_count_together()
    {
        Users.SetPin(Anna(), "Ben", Pin);
        for (var i = 0; i < LockOut.FreeFailures - 1; i++)
        {
            Refused(PeopleError.SignInRefused, () => Users.SignInByPin("Ben", OtherPin, null));
        }

        Assert.Equal("Ben sign-in-failed wrong-pin(3)", Trail[^1]);
        Refused(PeopleError.SignInRefused, () => Users.SignIn("Ben", "not the password"));
        Assert.NotNull(Refused(PeopleError.SignInRefused, () => Users.SignInByPin("Ben", OtherPin, null)).LockedUntil);
        Refused(PeopleError.LockedOut, () => Users.SignInByPin("Ben", Pin, null));
        Refused(PeopleError.LockedOut, () => Users.SignIn("Ben", Other));
        Clock.Pass(TimeSpan.FromSeconds(31));
        Assert.Equal("Ben", Users.SignInByPin("Ben", Pin, null).Name);
    }

    [Fact]
    public void Badges_of_nobody_lock_badges_and_nothing_else()
    {
        Users.SetBadge(Anna(), "Ben", Badge);
        for (var i = 0; i <= LockOut.FreeFailures; i++)
        {
            var number = i;
            Refused(PeopleError.SignInRefused, () => Users.SignInByBadge($"stranger {number}"));
        }

        Assert.Contains("no-such-badge(5)", Trail[^1], StringComparison.Ordinal);
        Assert.NotNull(Refused(PeopleError.LockedOut, () => Users.SignInByBadge(Badge)).LockedUntil);
        Refused(PeopleError.LockedOut, () => Users.FindBadge(Badge));
        Assert.Equal("Ben", Users.SignIn("Ben", Other).Name);
        Clock.Pass(TimeSpan.FromSeconds(31));
        Assert.Equal("Ben", Users.SignInByBadge(Badge).Name);

        // Who has a badge does not unlock guesses at those of others.
        Refused(PeopleError.SignInRefused, () => Users.SignInByBadge("stranger 9"));
        Assert.Contains("no-such-badge(6)", Trail[^1], StringComparison.Ordinal);
        Refused(PeopleError.LockedOut, () => Users.SignInByBadge(Badge));
        Clock.Pass(Credentials.BadgeMemory);
        Refused(PeopleError.SignInRefused, () => Users.SignInByBadge("stranger 10"));
        Assert.Contains("no-such-badge(1)", Trail[^1], StringComparison.Ordinal);
    }

    [Fact]
    public void Who_is_disabled_signs_in_with_nothing()
    {
        Users.SetPin(Anna(), "Ben", Pin);
        Users.SetBadge(Anna(), "Ben", Badge);
        Users.Disable(Anna(), "Ben");
        Refused(PeopleError.UserDisabled, () => Users.SignInByBadge(Badge));
        Refused(PeopleError.UserDisabled, () => Users.SignInByPin("Ben", Pin, null));
        Refused(PeopleError.SignInRefused, () => Users.SignInByPin("Ben", OtherPin, null));
    }

    [Fact]
    public void A_name_without_a_PIN_and_a_name_of_nobody_take_as_long_and_say_the_same()
    {
        var before = Users.Hashes.Comparisons;
        var nobody = Refused(PeopleError.SignInRefused, () => Users.SignInByPin("Eve", Pin, null)).Message;
        Assert.Equal(nobody, Refused(PeopleError.SignInRefused, () => Users.SignInByPin("Ben", Pin, null)).Message);
        Assert.Equal(before + 2, Users.Hashes.Comparisons);
    }

    [Fact]
    public void A_badge_signs_for_its_owner_alone()
    {
        Users.SetBadge(Anna(), "Ben", Badge);
        Users.SetBadge(Anna(), "Anna", OtherBadge);
        var session = new Session(Users, Clock, TimeSpan.FromMinutes(10), All);
        Refused(PeopleError.NotSigned, () => session.SignAgainByBadge(Badge, null));
        session.SignInByBadge(Badge, null);
        Refused(PeopleError.NotSigned, () => session.SignAgainByBadge(OtherBadge, null));
        var again = session.SignAgainByBadge(Badge, null);
        Users.Demand(again, Act.Approve);
        Refused(PeopleError.NotSigned, () => Users.Demand(again, Act.Approve));
    }

    [Fact]
    public void What_is_stored_is_of_no_use_without_the_key()
    {
        Users.SetPin(Anna(), "Ben", Pin);
        Users.SetBadge(Anna(), "Ben", Badge);
        var stored = Store.Write(t => t.Query("SELECT kind, hash FROM credential ORDER BY kind", r => (r.GetString(0), r.GetString(1))));
        Assert.Equal(["badge", "pin"], stored.Select(s => s.Item1));
        Assert.All(stored, s => Assert.DoesNotContain(Badge, s.Item2, StringComparison.Ordinal));
        Assert.All(stored, s => Assert.DoesNotContain(Pin, s.Item2, StringComparison.Ordinal));
        Assert.NotEqual(Credentials.BadgeHash(new byte[32], Badge), stored[0].Item2);
        Assert.False(Users.Hashes.Compare(stored[1].Item2, Pin).IsRight);
        Assert.False(Users.Hashes.Compare(stored[1].Item2, Credentials.PinSecret(new byte[32], "Ben", Pin)).IsRight);
        Assert.True(Users.Hashes.Compare(stored[1].Item2, Credentials.PinSecret(Key, "Ben", Pin)).IsRight);
    }

    // What signing in by badge and by PIN is refused for; null where the row was left alone.
    [Theory]
    [InlineData("UPDATE credential SET name_key = 'ANNA' WHERE kind = 'badge'", PeopleError.Tampered, null, true)]
    [InlineData(
        "UPDATE credential SET hash = (SELECT hash FROM credential WHERE name_key = 'ANNA') WHERE kind = 'pin' AND name_key = 'BEN'",
        null,
        PeopleError.Tampered,
        true)]
    [InlineData("UPDATE credential SET set_at = 0", PeopleError.Tampered, PeopleError.Tampered, true)]
    [InlineData("DELETE FROM credential", PeopleError.SignInRefused, PeopleError.SignInRefused, false)]
    public void What_somebody_else_wrote_is_found_and_lets_nobody_in(string sql, PeopleError? byBadge, PeopleError? byPin, bool isQuick)
    {
        Users.SetPin(Anna(), "Anna", OtherPin);
        Users.SetPin(Anna(), "Ben", Pin);
        Users.SetBadge(Anna(), "Ben", Badge);
        Store.Write(t => t.Execute(sql));
        Assert.False(new AuditTrail(Store, Keys).Verify().Holds);
        Assert.Equal(isQuick, Store.Tampered().Count > 0);
        Tried(byBadge, () => Users.SignInByBadge(Badge));
        Tried(byPin, () => Users.SignInByPin("Ben", Pin, null));

        static void Tried(PeopleError? error, Func<SignedIn> signIn)
        {
            if (error is { } refused)
            {
                Refused(refused, () => signIn());
            }
            else
            {
                Assert.Equal("Ben", signIn().Name);
            }
        }
    }

    [Fact]
    public void A_row_that_was_taken_away_and_is_put_back_is_found()
    {
        Users.SetBadge(Anna(), "Ben", Badge);
        var kept = Store.Write(t => t.First("SELECT hash, set_at, row_code FROM credential", r => Tuple.Create(
            r.GetString(0), r.GetInt64(1), r.GetString(2))))!;
        Users.RemoveBadge(Anna(), "Ben");
        Assert.True(new AuditTrail(Store, Keys).Verify().Holds);
        Store.Write(t => t.Execute(
            "UPDATE credential SET hash = @Hash, set_at = @At, row_code = @Code",
            [("Hash", kept.Item1), ("At", kept.Item2), ("Code", kept.Item3)]));
        Assert.Contains("badge of BEN", new AuditTrail(Store, Keys).Verify().Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Who_starts_over_leaves_nothing_that_others_sign_in_with()
    {
        Users.SetBadge(Anna(), "Ben", Badge);
        Users.SetPin(Anna(), "Ben", Pin);
        Store.Write(t => t.Execute("DELETE FROM person"));
        Users.AddFirst("Ben", Right);
        Refused(PeopleError.SignInRefused, () => Users.SignInByBadge(Badge));
        Refused(PeopleError.SignInRefused, () => Users.SignInByPin("Ben", Pin, null));
        Assert.Empty(Store.Tampered());
    }
}
