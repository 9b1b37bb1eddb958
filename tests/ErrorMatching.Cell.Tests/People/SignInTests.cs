namespace ErrorMatching.Cell.Tests;

public sealed class SignInTests : PeopleTest
{
    public SignInTests() => Users.AddFirst("Anna", Right);

    [Fact]
    public void Who_signs_in_is_in_the_trail()
    {
        var anna = Users.SignIn("aNNa", Right);
        Assert.Equal(("Anna", Role.Administrator, Clock.Now), (anna.Name, anna.Role, anna.At));
        Assert.Equal("Anna signed-in signed-in(administrator)", Trail[^1]);
    }

    [Fact]
    public void A_name_that_is_none_answers_like_a_wrong_password()
    {
        for (var i = 1; i <= 12; i++)
        {
            var before = Users.Hashes.Comparisons;
            var wrong = Assert.Throws<PeopleException>(() => Users.SignIn("Anna", "wrong"));
            var between = Users.Hashes.Comparisons;
            var nobody = Assert.Throws<PeopleException>(() => Users.SignIn("Nobody", "wrong"));
            Assert.Equal((wrong.Error, wrong.Message, wrong.LockedUntil), (nobody.Error, nobody.Message, nobody.LockedUntil));
            Assert.Equal(between - before, Users.Hashes.Comparisons - between);
            Clock.Pass(TimeSpan.FromSeconds(20));
        }
    }

    [Theory]
    [InlineData(""), InlineData("\0"), InlineData("a\nb"), InlineData("\ud800")]
    public void A_name_that_cannot_be_one_answers_so_as_well(string name) =>
        Refused(PeopleError.SignInRefused, () => Users.SignIn(name, Right));

    [Fact]
    public void A_name_of_a_megabyte_answers_so_as_well() =>
        Refused(PeopleError.SignInRefused, () => Users.SignIn(new string('a', 1 << 20), new string('b', 1 << 20)));

    [Theory]
    [InlineData("DELETE FROM sign_in_failure")]
    [InlineData("UPDATE sign_in_failure SET failures = 0")]
    [InlineData("UPDATE sign_in_failure SET failures = 4")]
    [InlineData("UPDATE sign_in_failure SET failed_at = 0")]
    public void Whoever_changes_the_rows_of_failures_unlocks_nobody(string tampering)
    {
        for (var i = 0; i < 6; i++)
        {
            Clock.Pass(TimeSpan.FromSeconds(31));
            Refused(PeopleError.SignInRefused, () => Users.SignIn("Anna", "wrong"));
        }

        Store.Database.Change((connection, transaction) => Sql.Execute(connection, tampering, transaction: transaction));

        Assert.Equal(Clock.Now.AddMinutes(1), Refused(PeopleError.LockedOut, () => Users.SignIn("anna", Right)).LockedUntil);
        Assert.Equal((6, Clock.Now.AddMinutes(1)), (Users.List()[0].Failures, Users.List()[0].LockedUntil));

        // The next failure counts on, and a success ends it.
        Clock.Pass(TimeSpan.FromSeconds(61));
        Assert.Equal(Clock.Now.AddMinutes(2), Refused(PeopleError.SignInRefused, () => Users.SignIn("Anna", "wrong")).LockedUntil);
        Clock.Pass(TimeSpan.FromSeconds(121));
        Users.SignIn("Anna", Right);
        Assert.Equal(0, Users.List()[0].Failures);
        Assert.Null(Refused(PeopleError.SignInRefused, () => Users.SignIn("Anna", "wrong")).LockedUntil);
    }

    [Fact]
    public void Whom_an_administrator_unlocks_is_unlocked_and_strangers_count_for_nobody()
    {
        Users.Add(Anna(), "Ben", Role.Setter, Other);
        for (var i = 0; i < 5; i++) Refused(PeopleError.SignInRefused, () => Users.SignIn("Ben", "wrong"));
        Refused(PeopleError.LockedOut, () => Users.SignIn("Ben", Other));
        Users.Enable(Anna(), "Ben");
        Users.SignIn("Ben", Other);
        for (var i = 0; i < 5; i++) Refused(PeopleError.SignInRefused, () => Users.SignIn("Ben", "wrong"));
        Users.SetPassword(Anna(), "Ben", "another word of his");
        Users.SignIn("Ben", "another word of his");
    }

    [Fact]
    public void Failures_lock_for_30_s_then_twice_as_long_each()
    {
        for (var i = 1; i <= 4; i++)
        {
            Assert.Null(Refused(PeopleError.SignInRefused, () => Users.SignIn("Anna", "wrong")).LockedUntil);
        }

        foreach (var seconds in new[] { 30, 60, 120, 240, 480, 960, 1920, 3600, 3600 })
        {
            var until = Clock.Now.AddSeconds(seconds);
            Assert.Equal(until, Refused(PeopleError.SignInRefused, () => Users.SignIn("Anna", "wrong")).LockedUntil);
            Clock.Pass(TimeSpan.FromSeconds(seconds - 1));
            Assert.Equal(until, Refused(PeopleError.LockedOut, () => Users.SignIn("Anna", Right)).LockedUntil);
            Clock.Pass(TimeSpan.FromSeconds(1));
        }

        Assert.Equal(13, Users.List()[0].Failures);
        Users.SignIn("Anna", Right);
        Assert.Equal((0, null), (Users.List()[0].Failures, Users.List()[0].LockedUntil));
    }

    [Fact]
    public void A_locked_name_is_not_compared_and_not_locked_longer()
    {
        Fail("Anna", 5);
        var (until, comparisons, entries) = (Users.List()[0].LockedUntil, Users.Hashes.Comparisons, Trail.Count);
        for (var i = 0; i < 20; i++)
        {
            Refused(PeopleError.LockedOut, () => Users.SignIn("Anna", "wrong"));
        }

        Assert.Equal((until, comparisons, entries), (Users.List()[0].LockedUntil, Users.Hashes.Comparisons, Trail.Count));
    }

    [Fact]
    public void One_name_that_is_locked_locks_no_other()
    {
        Users.Add(Anna(), "Ben", Role.Operator, Other);
        Fail("Ben", 5);
        Assert.NotNull(Users.SignIn("Anna", Right));
    }

    [Fact]
    public void A_success_forgets_failures()
    {
        Fail("Anna", 4);
        Users.SignIn("Anna", Right);
        Fail("Anna", 4);
        Assert.NotNull(Users.SignIn("Anna", Right));
    }

    [Fact]
    public void A_clock_that_is_set_back_locks_nobody_for_longer()
    {
        Fail("Anna", 5);
        Clock.Now = Clock.Now.AddYears(-1);
        var until = Refused(PeopleError.LockedOut, () => Users.SignIn("Anna", Right)).LockedUntil;
        Assert.Equal(Clock.Now.AddSeconds(30), until);
        Clock.Pass(TimeSpan.FromSeconds(30));
        Assert.NotNull(Users.SignIn("Anna", Right));
    }

    [Fact]
    public async Task Many_tries_at_once_are_not_more_than_one_after_another()
    {
        var tries = await Task.WhenAll(
            Enumerable.Range(0, 16).Select(_ => Task.Run(() => Assert.Throws<PeopleException>(() => Users.SignIn("Anna", "wrong")).Error)));
        Assert.Equal((5, 11), (tries.Count(e => e == PeopleError.SignInRefused), tries.Count(e => e == PeopleError.LockedOut)));
    }

    [Fact]
    public void Failures_are_in_the_trail_with_the_lock()
    {
        Fail("Anna", 5);
        Assert.Equal(
            [
                .. Enumerable.Range(1, 4).Select(i => $"Anna sign-in-failed wrong-password({i})"),
                "Anna locked until-utc(wrong-password(5), 2026-03-01 06:00:30)"],
            Trail.TakeLast(5));
    }

    [Fact]
    public void Guessed_names_do_not_fill_the_trail()
    {
        var before = Trail.Count;
        for (var i = 0; i < 200; i++)
        {
            Refused(PeopleError.SignInRefused, () => Users.SignIn($"guess {i}", "wrong"));
        }

        Assert.Equal(20, Trail.Count - before);
        Assert.All(Trail.Skip(before), e => Assert.StartsWith("unknown sign-in-failed no-such-name", e, StringComparison.Ordinal));
        Assert.EndsWith(" no-such-names", Trail[^1], StringComparison.Ordinal);
        Clock.Pass(TimeSpan.FromHours(2));
        Refused(PeopleError.SignInRefused, () => Users.SignIn("guess 200", "wrong"));
        Assert.Equal(21, Trail.Count - before);
    }

    [Fact]
    public void Guessed_names_do_not_fill_the_store_and_a_users_failures_stay()
    {
        Fail("Anna", 3);
        for (var i = 0; i < 1100; i++)
        {
            Refused(PeopleError.SignInRefused, () => Users.SignIn($"guess {i}", "wrong"));
        }

        Assert.Equal(1001, Store.Write(t => t.Value<long>("SELECT count(*) FROM sign_in_failure")));
        Assert.Equal(3, Users.List()[0].Failures);
        Clock.Pass(TimeSpan.FromDays(1.5));
        Refused(PeopleError.SignInRefused, () => Users.SignIn("another guess", "wrong"));
        Assert.Equal(2, Store.Write(t => t.Value<long>("SELECT count(*) FROM sign_in_failure")));
    }

    [Fact]
    public void Tries_before_there_was_a_user_are_not_the_users()
    {
        Fail("Ben", 5);
        Users.Add(Anna(), "Ben", Role.Operator, Other);
        Assert.NotNull(Users.SignIn("Ben", Other));
    }

    [Fact]
    public void A_hash_of_less_work_is_made_again_at_the_next_success()
    {
        var more = new UserBook(Store, Clock, new PasswordHashes(20));
        var hash = Hash();
        Assert.Throws<PeopleException>(() => more.SignIn("Anna", "wrong"));
        Assert.Equal(hash, Hash());
        more.SignIn("Anna", Right);
        Assert.NotEqual(hash, Hash());
        Assert.Equal((true, false), new PasswordHashes(20).Compare(Hash(), Right));
        Assert.NotNull(more.SignIn("Anna", Right));

        string Hash() => Store.Write(t => t.Value<string>("SELECT password FROM person"))!;
    }

    private void Fail(string name, int times)
    {
        for (var i = 0; i < times; i++)
        {
            Refused(PeopleError.SignInRefused, () => Users.SignIn(name, "wrong"));
        }
    }
}
