using System.Text;
using ErrorMatching.Nc;

namespace ErrorMatching.Freeform.Tests;

/// <summary>Texts of a job in the comments of programs, for all controls and all templates.</summary>
public sealed class CommentTextTests
{
    // Each is a name and an order. They end comments, begin others, are executed, have letters of many alphabets, or are too long.
    private static readonly string[] Names =
        [
            "Wing 3/4, left", "bad)\nG0 Z-100(", "a;b%c\"d{e}", "Gehäuse für Röntgengerät Ø12", "Деталь №5", "曲面一", "Επιφάνεια",
            "ABORT, the part", "Log , x", "LOGOPEN,/tmp/x", "probeopen /tmp/x", "msg,x", new('x', 300), "e\u0301te\u0301", "（１２）", "",
        ];

    // What the templates themselves have LinuxCNC execute.
    private static readonly string[] Ours =
        [
            "(MSG, point ", "(MSG, probe into the spindle: ", "(LOG,ERRORMATCH PROBE PLAN ", "(LOG,P", "(LOG,END)",
            "(LOGOPEN,errormatch-probe.log)", "(LOGCLOSE)", "(ABORT,no tool call in this program)",
        ];

    public static TheoryData<string> Dialects => [.. NcDialects.All.Where(d => d.HasCodes).Select(d => d.Name)];

    public static TheoryData<string> Templates => [.. ProbingTemplate.Names.Where(n => n != "heidenhain-klartext")];

    [Theory]
    [InlineData("Gehäuse für Röntgengerät", "GEHAEUSE FUER ROENTGENGERAET", "Gehaeuse fuer Roentgengeraet")]
    [InlineData("Straße, Łódź, Ångström", "STRASSE, LODZ, ANGSTROEM", "Strasse, Lodz, Angstroem")]
    [InlineData("Деталь щит", "DETAL SHCHIT", "Detal shchit")]
    [InlineData("Επιφάνεια θ", "EPIFANEIA TH", "Epifaneia th")]
    [InlineData("曲面 7", "-- 7", "-- 7")]
    [InlineData("e\u0301te\u0301", "ETE", "ete")]
    [InlineData("Ø12 ±0.01 µm", "O12 +/-0.01 UM", "O12 +/-0.01 um")]
    [InlineData("ＡＢ１２", "AB12", "AB12")]
    [InlineData("a_b #1 <x> 50%", "A-B -1 -X- 50-", "a_b #1 <x> 50-")]
    [InlineData("two\nlines (and) \"more\"", "TWO-LINES -AND- -MORE-", "two-lines -and- -more-")]
    public void Letters_outside_of_the_control_s_set_are_spelled_with_its_own(string text, string capitals, string ascii)
    {
        Assert.Equal(capitals, new CommentText(NcDialects.FanucMill).Of(text));
        Assert.Equal(ascii, new CommentText(NcDialects.Siemens840D).Of(text));
        Assert.Equal(ascii, new CommentText(NcDialects.LinuxCnc).Of(text));
    }

    [Theory]
    [InlineData("ABORT, the part")]
    [InlineData("Log , x")]
    [InlineData("LOGOPEN,/tmp/x")]
    [InlineData("probeopen /tmp/x")]
    [InlineData("m s g,x")]
    public void A_name_that_linuxcnc_would_execute_becomes_a_comment(string name)
    {
        Assert.Equal("- " + name, new CommentText(NcDialects.LinuxCnc).Of(name));
        Assert.Equal(name, new CommentText(NcDialects.Siemens840D).Of(name));
    }

    [Fact]
    public void A_comment_that_is_too_long_is_cut_inside_of_what_encloses_it()
    {
        var fanuc = new CommentText(NcDialects.FanucMill);
        Assert.Equal($"({new string('A', 78)})", fanuc.Line($"({new string('A', 78)})"));
        Assert.Equal($"({new string('A', 78)})", fanuc.Line($"({new string('A', 79)})"));
        Assert.Equal($"O1000 ({new string('A', 78)})", fanuc.Line($"O1000 ({new string('A', 90)})"));
        Assert.Equal(new string('X', 100), fanuc.Line(new('X', 100)));
        Assert.Equal($"; {new string('a', 198)}", new CommentText(NcDialects.Siemens840D).Line($"; {new string('a', 199)}"));
    }

    [Theory]
    [MemberData(nameof(Dialects))]
    public void Comments_of_cutting_programs_are_the_control_s_whatever_the_job_says(string name)
    {
        var dialect = NcDialects.Named(name);
        var toolpath = Plans.Passes(0.05, 0.01);
        var path = Plans.Path(Shapes.Plane(10, 1), toolpath, dialect: dialect);
        foreach (var text in Names)
        {
            foreach (var tool in new[] { null, new ToolCall(3, null, 3) })
            {
                var job = Plans.Job(toolpath, name) with { Name = text, WorkOrder = text };
                job = job with { Toolpath = job.Toolpath with { Tool = tool } };
                AssertComments(FinishingProgram.Write(path, job, dialect, CuttingStage.SemiFinishing), dialect);
            }
        }
    }

    [Theory]
    [MemberData(nameof(Templates))]
    public void Comments_of_probing_programs_are_the_control_s_whatever_the_job_says(string template)
    {
        var (dialect, plan) = (Programs.Dialect(template), Programs.Plan());
        foreach (var text in Names)
        {
            foreach (var tool in new[] { null, new ToolCall(90, null, 90) })
            {
                var called = plan with { Measuring = plan.Measuring with { Tool = tool } };
                AssertComments(ProbingProgram.Of(called, text, dialect, ProbingTemplate.Named(template), text).Bytes.Span, dialect);
            }
        }
    }

    private static void AssertComments(ReadOnlySpan<byte> bytes, NcDialect dialect)
    {
        var program = NcProgram.Read(bytes.ToArray(), dialect.Syntax);
        Assert.DoesNotContain(bytes.ToArray(), b => b > 126 || (b < 32 && b != 10));
        var run = NcInterpreter.Run(program, dialect);
        Assert.Null(run.Refusal);
        Assert.Empty(Plans.Faults(run));
        Assert.DoesNotContain(run.Motions, m => m.End.Z == -100);
        for (var i = 0; i < program.BlockCount; i++)
        {
            foreach (var token in program.Tokens(program[i]))
            {
                Assert.NotEqual(NcTokenKind.Invalid, token.Kind);
                var comment = Encoding.ASCII.GetString(program.Bytes.Span.Slice(token.Start, token.Length));
                var isOurs = dialect.Syntax == NcSyntax.LinuxCnc && Ours.Any(o => comment.StartsWith(o, StringComparison.Ordinal));
                if (token.Kind != NcTokenKind.Comment || isOurs)
                {
                    continue;
                }

                Assert.True(comment.Length <= dialect.CommentLength, comment);
                Assert.Matches(
                    dialect.CommentCapitals ? "^\\([A-Z0-9 .,+/=-]*\\)$"
                        : dialect.Syntax != NcSyntax.Siemens ? "^\\([ -'*-~]*\\)$"
                        : "^;[ -~]*$",
                    comment);
                if (dialect.Syntax != NcSyntax.LinuxCnc)
                {
                    continue;
                }

                Assert.DoesNotMatch(
                    "(?i)^\\(\\s*(msg|debug|print|log|logopen|logappend|abort|py|pyrun)\\s*,|^\\(\\s*(logclose|probe(open|close))",
                    comment);
            }
        }
    }
}
