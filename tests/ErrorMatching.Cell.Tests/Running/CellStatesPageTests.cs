using System.Text.RegularExpressions;
using ErrorMatching.Testing;

namespace ErrorMatching.Cell.Tests;

public sealed partial class CellStatesPageTests
{
    [Fact]
    public void The_page_has_the_table_of_the_code()
    {
        var rows = Row().Matches(File.ReadAllText(Repository.PathTo("docs", "cell-states.md")));
        Assert.Equal(
            Enum.GetNames<CorrectionState>().Select(n => n.ToLowerInvariant()).Order(), rows.Select(r => r.Groups["state"].Value).Order());
        Assert.All(rows, row => Assert.Equal(
            CorrectionSteps.From(Enum.Parse<CorrectionState>(
                row.Groups["state"].Value, ignoreCase: true)).Select(s => s.ToString().ToLowerInvariant()),
            row.Groups["next"].Value.Split(", ", StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries)));
    }

    [GeneratedRegex(
        @"^\| (?<state>archived|recognized|computed|proposed|approved|uploading|verified|released|failed|superseded|recorded|refused|"
        + @"rejected|reverted) \| [^|]+ \|(?<next>[a-z, ]*)\|$", RegexOptions.Multiline, 1000)]
    private static partial Regex Row();
}
