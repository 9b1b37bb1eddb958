namespace ErrorMatching.Cell.Tests;

public sealed class RightsTests
{
    // Issue and manual: operator (see, acknowledge, release, reject), setter (shelve, approve, revert, edit and prepare jobs),
    // administrator (users, machines, policy).
    private const string Table = """
                       operator setter administrator signed
        See            yes      yes    yes           no
        Acknowledge    yes      yes    yes           no
        Shelve         no       yes    yes           no
        Release        yes      yes    yes           no
        Reject         yes      yes    yes           no
        Approve        no       yes    yes           yes
        Revert         no       yes    yes           yes
        EditJobs       no       yes    yes           yes
        PrepareJobs    no       yes    yes           no
        ManageUsers    no       no     yes           yes
        ManageMachines no       no     yes           yes
        ManagePolicy   no       no     yes           yes
        """;

    public static TheoryData<string> Rows => [.. Table.Split('\n')[1..]];

    [Theory]
    [MemberData(nameof(Rows))]
    public void Each_role_may_do_what_the_table_says(string row)
    {
        var cells = row.Split(' ', StringSplitOptions.RemoveEmptyEntries);
        var act = Enum.Parse<Act>(cells[0]);
        var roles = Enum.GetValues<Role>();
        Assert.Equal(3, roles.Length);
        Assert.Equal(cells[1..4], roles.Select(r => Rights.Allows(r, act) ? "yes" : "no"));
        Assert.Equal(roles.First(r => Rights.Allows(r, act)), Rights.LeastFor(act));
        Assert.Equal(cells[4] == "yes", Rights.IsSigned(act));
    }

    [Fact]
    public void Each_act_is_in_the_table() => Assert.Equal(Enum.GetNames<Act>(), Table.Split('\n')[1..].Select(r => r.Split(' ')[0]));

    [Fact]
    public void The_manual_has_the_same_table()
    {
        var manual = File.ReadAllLines(ErrorMatching.Testing.Repository.PathTo("docs", "users-and-rights.md"));
        foreach (var act in Enum.GetValues<Act>())
        {
            var row = Assert.Single(manual, l => l.Contains($"<!-- {act} -->", StringComparison.Ordinal)).Split('|');
            Assert.Equal(Enum.GetValues<Role>().Select(r => Rights.Allows(r, act) ? "yes" : ""), row[2..5].Select(c => c.Trim()));
            Assert.Equal(Rights.IsSigned(act) ? "yes" : "", row[5].Trim());
        }
    }
}
