using System.Security.Cryptography;
using System.Text;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating.Tests;

/// <summary>The comment that keeps a correction from being applied twice:
/// where it stands, that it is found again, what it refuses.</summary>
public sealed class MarkerTests
{
    private const string Body = "N20 G0 X0. Y-20.\nN40 G1 X0. Y-3. F300\nN50 X50.\nN60 Y-20.\nN70 M30";

    private static readonly string Text = new Marker(new('A', 64), new('b', 64)).TextIn(NcSyntax.Iso);

    [Fact]
    public void It_carries_the_hashes_of_the_measurement_and_of_the_base_program()
    {
        var match = new MatchCase(Programs.ToolBelow);
        var csv = "point,x_mm,y_mm\n1,10,0.1\n2,40,0.1\n";

        Assert.Equal($"(ERRORMATCH MEASUREMENT={Hash(csv)} BASE={Hash(Programs.ToolBelow)})", match.Match().Marker!.TextIn(NcSyntax.Iso));
        Assert.Equal(match.Match().Marker!.TextIn(NcSyntax.Iso), match.Match().Proof.Marker);
        Assert.Equal(match.Match().Marker!.TextIn(NcSyntax.Iso), match.Report().Proof.Marker);
        Assert.Contains(
            "\nO1000 (COVER)\n" + match.Match().Marker!.TextIn(NcSyntax.Iso) + "\nN10 ",
            Encoding.ASCII.GetString(match.Match().Program.Span),
            StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("%\nO1000 (COVER)\n", "\n")]
    [InlineData("%\r\nO1000\r\n", "\r\n")]
    [InlineData("O1000\r", "\r")]
    [InlineData("%\n", "\n")]
    [InlineData("", "\n")]
    [InlineData("\n%\n\n:1000\n", "\n")]
    [InlineData("%\n(COVER)\nO1000\n", "\n")]
    public void It_is_a_line_behind_percent_sign_and_program_number(string head, string lineEnd)
    {
        var program = head + Body.Replace("\n", lineEnd, StringComparison.Ordinal);

        Assert.Equal(head + Text + lineEnd + program[head.Length..], Inserted(program));
    }

    [Fact]
    public void A_comment_that_is_no_head_stays_behind_it() =>
        Assert.Equal("%\nO1000\n" + Text + "\n(COVER)\n" + Body, Inserted("%\nO1000\n(COVER)\n" + Body));

    [Fact]
    public void Behind_a_mark_of_UTF_8_the_first_block_stays_first()
    {
        var program = NcProgram.FromText("\uFEFFN10 G21\n" + Body);
        Assert.Equal(
            "\uFEFFN10 G21\n" + Text + "\n" + Body, Encoding.UTF8.GetString(new Marker(new('a', 64), new('b', 64)).InsertInto(program)));
    }

    [Fact]
    public void Behind_a_last_line_without_end_it_begins_a_new_one()
    {
        Assert.Equal("%\r\nO1000\r\n" + Text, Inserted("%\r\nO1000"));
        Assert.Equal("O1000\n" + Text, Inserted("O1000"));
    }

    [Fact]
    public void It_is_found_again_wherever_it_stands()
    {
        var marker = new Marker(new('a', 64), new('b', 64));

        Assert.Equal([(1, marker)], Marker.Find(NcProgram.FromText("%\n" + Text + "\n" + Body)));
        Assert.Equal([(2, marker)], Marker.Find(NcProgram.FromText("N10 G21\n\nN15 " + Text + "\n" + Body)));
        Assert.Empty(Marker.Find(NcProgram.FromText("(NO ERRORMATCHING HERE)\n" + Body)));
    }

    [Theory]
    [InlineData("part", Marker.AlreadyCompensated)]
    [InlineData("counterpart", Marker.MarkerDamaged)]
    public void A_marker_that_an_editor_damaged_refuses_all_the_same(string from, string code)
    {
        var match = new MatchCase(Programs.ToolBelow)
        {
            Counterpart = "1 10 -0.04; 2 40 -0.04",
            Compensation = $$"""{ "from": "{{from}}" }"""
        };
        var marked = match with { Program = Encoding.ASCII.GetString(match.Match().Program.Span) };

        foreach (var damaged in new[]
        {
            marked.Program.Replace(" BASE=", " ", StringComparison.Ordinal),
            marked.Program.Replace("(ERRORMATCH ", "(ERRORMATCH  COVER ", StringComparison.Ordinal),
            marked.Program[..120] + ")" + marked.Program[marked.Program.IndexOf("\nN10", StringComparison.Ordinal)..],
            marked.Program[..120] + marked.Program[marked.Program.IndexOf("\nN10", StringComparison.Ordinal)..],
            marked.Program.Replace(match.Match().Marker!.TextIn(NcSyntax.Iso), "(errormatch)", StringComparison.Ordinal),
        })
        {
            Assert.Equal((code, "line 3", 3), Place((marked with { Program = damaged }).Refusal()));
        }
    }

    [Fact]
    public void Letters_of_another_case_are_the_same_marker()
    {
        var match = new MatchCase(Programs.ToolBelow)
        {
            Counterpart = "1 10 -0.04; 2 40 -0.04",
            Compensation = """{ "from": "counterpart" }"""
        };
        var marker = match.Match().Marker!;
        var lower = Encoding.ASCII.GetString(match.Match().Program.Span).Replace(
            marker.TextIn(NcSyntax.Iso), marker.TextIn(NcSyntax.Iso).ToLowerInvariant(), StringComparison.Ordinal);

        Assert.Equal([(2, marker)], Marker.Find(NcProgram.FromText(lower)));
    }

    [Fact]
    public void Feed_forward_starts_from_the_nominal_program_only()
    {
        var match = new MatchCase(Programs.ToolBelow);
        var again = match with { Program = Encoding.ASCII.GetString(match.Match().Program.Span) };

        Assert.Equal((Marker.AlreadyCompensated, "line 3", 3), Place(again.Refusal()));
        Assert.Equal((Marker.AlreadyCompensated, "line 3", 3), Place((again with { Part = "1 10 0.2; 2 40 0.2" }).Refusal()));
        Assert.Equal((Marker.AlreadyCompensated, "line 3", 3), Place((again with { Part = "1 10 0; 2 40 0" }).Refusal()));
    }

    [Fact]
    public void Feedback_goes_on_from_a_compensated_program_but_never_twice_with_one_measurement()
    {
        // Part at 0.1. The nominal program cut at -0.04, so it goes to -2.86; that one cut at 0.09, so it goes 0.01 further.
        var first = new MatchCase(Programs.ToolBelow)
        {
            Counterpart = "1 10 -0.04; 2 40 -0.04",
            Compensation = """{ "from": "counterpart" }"""
        };
        var cut = Encoding.ASCII.GetString(first.Match().Program.Span);
        var second = first with { Program = cut, Counterpart = "1 10 0.09; 2 40 0.09" };
        var result = second.Match();
        var found = Marker.Find(result.After.Program);

        Assert.Equal(["N40 G1 X0. Y-2.85 F300"], second.Changed());
        Assert.Equal([result.Marker!, first.Match().Marker!], found.Select(f => f.Marker!));
        Assert.Equal(Hash(cut).ToLowerInvariant(), result.Marker!.BaseSha256);
        Assert.Equal((Marker.SameMeasurement, "line 3", 3), Place((first with { Program = cut }).Refusal()));

        var third = second with { Program = Encoding.ASCII.GetString(result.Program.Span) };
        Assert.Equal((Marker.SameMeasurement, "line 3", 3), Place(third.Refusal()));
        Assert.Equal((Marker.SameMeasurement, "line 4", 4), Place((third with { Counterpart = first.Counterpart }).Refusal()));
    }

    [Theory]
    [InlineData("generic")]
    [InlineData("fanuc")]
    [InlineData("delta-nc300")]
    [InlineData("linuxcnc")]
    public void Every_dialect_reads_it_as_a_comment(string dialect)
    {
        var result = (new MatchCase(Programs.ToolBelow) { Dialect = dialect }).Match();

        Assert.Empty(result.After.Problems);
        Assert.Single(Marker.Find(result.After.Program));
    }

    private static string Inserted(string program) =>
        Encoding.ASCII.GetString(new Marker(new('a', 64), new('b', 64)).InsertInto(NcProgram.FromText(program)));

    private static (string Code, string? Block, int? Line) Place(Refusal refusal) =>
        (refusal.Code, refusal.Place.Block, refusal.Place.Line);

    private static string Hash(string text) => Convert.ToHexString(SHA256.HashData(Encoding.ASCII.GetBytes(text)));
}
