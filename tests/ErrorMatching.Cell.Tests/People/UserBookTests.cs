namespace ErrorMatching.Cell.Tests;

public sealed class UserBookTests : PeopleTest
{
    [Fact]
    public void A_new_store_has_no_users_and_no_password_that_opens_it()
    {
        Assert.True(Users.IsEmpty);
        Refused(PeopleError.NoUsers, () => Users.SignIn("admin", "admin"));
        Refused(PeopleError.NoUsers, () => Users.SignIn("", ""));
    }

    [Fact]
    public void The_first_user_is_an_administrator_and_needs_nobody()
    {
        var anna = Users.AddFirst("Anna", Right);
        Assert.Equal(new User("Anna", Role.Administrator, false, Clock.Now, Clock.Now), anna);
        Assert.Equal(anna, Assert.Single(Users.List()));
        Assert.Equal("console user-added Anna first-administrator", Trail[^1]);
    }

    [Fact]
    public void There_is_one_first_user()
    {
        Users.AddFirst("Anna", Right);
        Refused(PeopleError.NotSigned, () => Users.AddFirst("Ben", Right));
        Assert.Single(Users.List());
    }

    [Fact]
    public void The_first_users_name_and_password_are_looked_at_as_well()
    {
        Refused(PeopleError.BadUserName, () => Users.AddFirst("", Right));
        Refused(PeopleError.WeakPassword, () => Users.AddFirst("Anna", "Anna"));
        Assert.True(Users.IsEmpty);
    }

    [Theory]
    [InlineData(Role.Operator), InlineData(Role.Setter), InlineData(Role.Administrator)]
    public void An_administrator_adds_users(Role role)
    {
        Users.Add(Anna(), "Ben", role, Other);
        Assert.Equal([("Anna", Role.Administrator), ("Ben", role)], Users.List().Select(u => (u.Name, u.Role)));
        Assert.Equal($"Anna user-added Ben as-role({role.ToString().ToLowerInvariant()})", Trail[^1]);
        Assert.Equal(role, Users.SignIn("Ben", Other).Role);
    }

    [Theory]
    [InlineData("Anna"), InlineData("anna"), InlineData("ANNA")]
    public void Names_are_unique_without_regard_to_case(string name)
    {
        Refused(PeopleError.UserExists, () => Users.Add(Anna(), name, Role.Setter, Other));
        Assert.Single(Users.List());
        Assert.Equal("Anna", Users.SignIn(name, Right).Name);
    }

    [Fact]
    public void Only_an_administrator_changes_users()
    {
        Users.Add(Anna(), "Ben", Role.Setter, Other);
        Users.Add(Anna(), "Cem", Role.Operator, Other);
        foreach (var name in new[] { "Ben", "Cem" })
        {
            Refused(PeopleError.NotAllowed, () => Users.Add(Users.SignIn(name, Other), "Dan", Role.Operator, Right));
            Refused(PeopleError.NotAllowed, () => Users.Disable(Users.SignIn(name, Other), "Anna"));
            Refused(PeopleError.NotAllowed, () => Users.Enable(Users.SignIn(name, Other), "Anna"));
            Refused(PeopleError.NotAllowed, () => Users.SetRole(Users.SignIn(name, Other), name, Role.Administrator));
            Refused(PeopleError.NotAllowed, () => Users.SetPassword(Users.SignIn(name, Other), "Anna", Other));
        }

        Assert.Equal([Role.Administrator, Role.Setter, Role.Operator], Users.List().Select(u => u.Role));
        Assert.DoesNotContain(Users.List(), u => u.IsDisabled);
        Assert.NotNull(Users.SignIn("Anna", Right));
    }

    [Fact]
    public void Each_change_of_users_takes_a_password_of_its_own()
    {
        var by = Anna();
        Users.Add(by, "Ben", Role.Setter, Other);
        Refused(PeopleError.NotSigned, () => Users.SetRole(by, "Ben", Role.Operator));
        Refused(PeopleError.NotSigned, () => Users.Disable(by, "Ben"));
        Assert.Equal(Role.Setter, Users.List()[1].Role);
    }

    [Fact]
    public void A_signature_is_good_for_two_minutes()
    {
        var (early, late) = (Anna(), Anna());
        Clock.Run(TimeSpan.FromMinutes(2));
        Users.Demand(early, Act.Approve);
        Clock.Run(TimeSpan.FromTicks(1));
        Refused(PeopleError.NotSigned, () => Users.Demand(late, Act.Approve));
        Users.Demand(late, Act.Release);
    }

    [Fact]
    public void A_role_that_is_changed_counts_at_once()
    {
        Users.Add(Anna(), "Ben", Role.Setter, Other);
        var ben = Users.SignIn("Ben", Other);
        Users.Demand(ben, Act.EditJobs);
        Users.SetRole(Anna(), "ben", Role.Operator);
        Refused(PeopleError.NotAllowed, () => Users.Demand(ben, Act.EditJobs));
        Users.Demand(ben, Act.Release);
        Assert.Equal("Anna role-set Ben to-role(operator)", Trail.Last(e => e.Contains("role-set", StringComparison.Ordinal)));
    }

    [Fact]
    public void Who_is_disabled_is_out_at_once_until_enabled()
    {
        Users.Add(Anna(), "Ben", Role.Operator, Other);
        var ben = Users.SignIn("Ben", Other);
        Assert.True(Users.Disable(Anna(), "BEN").IsDisabled);
        Refused(PeopleError.UserDisabled, () => Users.Demand(ben, Act.See));
        Refused(PeopleError.UserDisabled, () => Users.SignIn("Ben", Other));
        Refused(PeopleError.SignInRefused, () => Users.SignIn("Ben", Right));
        Assert.False(Users.Enable(Anna(), "Ben").IsDisabled);
        Assert.NotNull(Users.SignIn("Ben", Other));
        Assert.Equal(
            ["Anna user-disabled Ben", "Anna user-enabled Ben"], Trail.Where(e => e.Contains("abled Ben", StringComparison.Ordinal)));
    }

    [Fact]
    public void The_last_administrator_stays()
    {
        Users.Add(Anna(), "Ben", Role.Setter, Other);
        Refused(PeopleError.LastAdministrator, () => Users.Disable(Anna(), "Anna"));
        Refused(PeopleError.LastAdministrator, () => Users.SetRole(Anna(), "Anna", Role.Setter));
        Users.SetRole(Anna(), "Ben", Role.Administrator);
        Users.Disable(Anna(), "Ben");
        Refused(PeopleError.LastAdministrator, () => Users.Disable(Anna(), "Anna"));
        Users.Enable(Anna(), "Ben");
        Assert.Equal(Role.Operator, Users.SetRole(Anna(), "Anna", Role.Operator).Role);
        Refused(PeopleError.LastAdministrator, () => Users.Disable(Users.SignIn("Ben", Other), "Ben"));
        Users.Disable(Users.SignIn("Ben", Other), "Anna");
    }

    [Fact]
    public void Everybody_sets_their_own_password_and_signs_with_the_old_one()
    {
        Users.Add(Anna(), "Ben", Role.Operator, Other);
        Clock.Pass(TimeSpan.FromDays(1));
        var ben = Users.SetPassword(Users.SignIn("Ben", Other), "ben", "a third one for Ben");
        Assert.Equal((Clock.Now, Clock.Now.AddDays(-1)), (ben.PasswordAt, ben.AddedAt));
        Assert.Equal("Ben password-set Ben", Trail[^1]);
        Refused(PeopleError.SignInRefused, () => Users.SignIn("Ben", Other));
        var by = Users.SignIn("Ben", "a third one for Ben");
        Users.SetPassword(by, "Ben", Other);
        Refused(PeopleError.NotSigned, () => Users.SetPassword(by, "Ben", Right));
        Refused(PeopleError.WeakPassword, () => Users.SetPassword(Users.SignIn("Ben", Other), "Ben", "password1234"));
    }

    [Fact]
    public void An_administrator_sets_a_lost_password_and_unlocks_with_it()
    {
        Users.Add(Anna(), "Ben", Role.Operator, Other);
        for (var i = 0; i < 5; i++)
        {
            Refused(PeopleError.SignInRefused, () => Users.SignIn("Ben", "lost"));
        }

        Refused(PeopleError.LockedOut, () => Users.SignIn("Ben", Other));
        Assert.Equal(Clock.Now.AddSeconds(30), Users.List()[1].LockedUntil);
        Users.SetPassword(Anna(), "Ben", "a third one for Ben");
        Assert.NotNull(Users.SignIn("Ben", "a third one for Ben"));
    }

    [Fact]
    public void Nobody_unknown_is_changed()
    {
        Refused(PeopleError.UnknownUser, () => Users.Disable(Anna(), "Ben"));
        Refused(PeopleError.UnknownUser, () => Users.Enable(Anna(), "Ben"));
        Refused(PeopleError.UnknownUser, () => Users.SetRole(Anna(), "Ben", Role.Setter));
        Refused(PeopleError.UnknownUser, () => Users.SetPassword(Anna(), "Ben", Right));
    }

    public static TheoryData<Role, Act> All => [.. Enum.GetValues<Role>().SelectMany(r => Enum.GetValues<Act>().Select(a => (r, a)))];

    [Theory]
    [MemberData(nameof(All))]
    public void What_is_demanded_is_what_the_table_allows(Role role, Act act)
    {
        Users.Add(Anna(), "Ben", role, Other);
        var ben = Users.SignIn("Ben", Other);
        if (Rights.Allows(role, act))
        {
            Users.Demand(ben, act);
        }
        else
        {
            Assert.Contains(
                Rights.LeastFor(act).ToString().ToLowerInvariant(),
                Refused(PeopleError.NotAllowed, () => Users.Demand(ben, act)).Message,
                StringComparison.Ordinal);
        }
    }

    [Fact]
    public void Only_its_owner_reads_the_store_and_a_copy_of_it()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "Windows has lists of rights instead.");
        Users.AddFirst("Anna", Right);
        Store.Backup(PathOf("copy.db"));
        foreach (var file in new[] { "cell.db", "cell.db-wal", "copy.db" })
        {
            Assert.Equal(
                UnixFileMode.UserRead | UnixFileMode.UserWrite, OperatingSystem.IsWindows() ? default : File.GetUnixFileMode(PathOf(file)));
        }
    }

    [Fact]
    public void No_password_is_in_the_store()
    {
        Users.Add(Anna(), "Ben", Role.Operator, Other);
        Refused(PeopleError.SignInRefused, () => Users.SignIn("typed into the wrong line", Other));
        Store.Backup(PathOf("copy.db"));
        var bytes = System.Text.Encoding.Latin1.GetString(File.ReadAllBytes(PathOf("copy.db")));
        Assert.Contains("Ben", bytes, StringComparison.Ordinal);
        Assert.All([Right, Other, "typed into the wrong line"], s => Assert.DoesNotContain(s, bytes, StringComparison.OrdinalIgnoreCase));
    }
}
