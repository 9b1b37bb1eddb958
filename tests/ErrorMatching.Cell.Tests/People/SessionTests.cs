namespace ErrorMatching.Cell.Tests;

public sealed class SessionTests : PeopleTest
{
    private static readonly TimeSpan Idle = TimeSpan.FromMinutes(10);
    private readonly Session _session;

    public SessionTests()
    {
        Users.AddFirst("Anna", Right);
        _session = new Session(Users, Clock, Idle, SignInWays.Password);
    }

    [Fact]
    public void Nobody_sits_there_at_first()
    {
        Assert.Null(_session.Who);
        _session.Touch();
        _session.SignOut();
        Assert.Null(_session.Who);
        Refused(PeopleError.NotSigned, () => _session.SignAgain(Right));
    }

    [Fact]
    public void Who_signs_in_sits_there_until_signing_out()
    {
        _session.SignIn("anna", Right);
        Assert.Equal("Anna", _session.Who?.Name);
        _session.SignOut();
        Assert.Null(_session.Who);
        Assert.Equal("Anna signed-out by-hand", Trail[^1]);
    }

    [Fact]
    public void Idleness_signs_out_once()
    {
        _session.SignIn("Anna", Right);
        Clock.Pass(Idle - TimeSpan.FromTicks(1));
        Assert.NotNull(_session.Who);
        Clock.Pass(TimeSpan.FromTicks(1));
        Assert.Null(_session.Who);
        Assert.Null(_session.Who);
        Assert.Equal("Anna signed-out idle", Assert.Single(Trail, e => e.Contains("signed-out", StringComparison.Ordinal)));
    }

    [Fact]
    public void A_key_keeps_the_seat_and_looking_does_not()
    {
        _session.SignIn("Anna", Right);
        for (var i = 0; i < 5; i++)
        {
            Clock.Pass(Idle * 0.9);
            _session.Touch();
        }

        Assert.NotNull(_session.Who);
        Clock.Pass(Idle * 0.6);
        Assert.NotNull(_session.Who);
        Clock.Pass(Idle * 0.6);
        Assert.Null(_session.Who);
    }

    [Fact]
    public void A_key_does_not_bring_back_a_seat_that_was_left()
    {
        _session.SignIn("Anna", Right);
        Clock.Pass(Idle);
        _session.Touch();
        Assert.Null(_session.Who);
    }

    [Fact]
    public void A_computer_that_sleeps_is_idle()
    {
        _session.SignIn("Anna", Right);
        Clock.Now += TimeSpan.FromHours(8);
        Assert.Null(_session.Who);
    }

    [Fact]
    public void A_clock_that_is_set_back_keeps_nobody()
    {
        _session.SignIn("Anna", Right);
        Clock.Now -= TimeSpan.FromDays(1);
        Assert.NotNull(_session.Who);
        Clock.Run(Idle);
        Assert.Null(_session.Who);
    }

    [Fact]
    public void Approving_takes_the_password_again_each_time()
    {
        var seat = _session.SignIn("Anna", Right);
        Users.Demand(seat, Act.Release);
        Users.Demand(seat, Act.Reject);
        Clock.Pass(TimeSpan.FromMinutes(3));
        Refused(PeopleError.NotSigned, () => Users.Demand(seat, Act.Approve));
        var signed = _session.SignAgain(Right);
        Users.Demand(signed, Act.Approve);
        Refused(PeopleError.NotSigned, () => Users.Demand(signed, Act.Revert));
        Users.Demand(_session.SignAgain(Right), Act.Revert);
    }

    [Fact]
    public void Wrong_passwords_count_when_signing_again_and_the_seat_stays()
    {
        _session.SignIn("Anna", Right);
        for (var i = 0; i < 5; i++)
        {
            Refused(PeopleError.SignInRefused, () => _session.SignAgain("wrong"));
        }

        Refused(PeopleError.LockedOut, () => _session.SignAgain(Right));
        Assert.NotNull(_session.Who);
    }

    [Fact]
    public void The_next_one_takes_the_seat_and_a_failed_try_leaves_it_empty()
    {
        Users.Add(Anna(), "Ben", Role.Operator, Other);
        _session.SignIn("Anna", Right);
        _session.SignIn("Ben", Other);
        Assert.Equal("Ben", _session.Who?.Name);
        Assert.Contains("Anna signed-out by-hand", Trail);
        Refused(PeopleError.SignInRefused, () => _session.SignIn("Anna", "wrong"));
        Assert.Null(_session.Who);
    }
}
