using System.Text;
using ErrorMatching.Testing;

namespace ErrorMatching.Console.Tests;

/// <summary><c>-</c> names standard input, and standard output behind <c>--out</c>.</summary>
public sealed class StandardStreamTests
{
    private static readonly string Program = Repository.PathTo("samples", "complex-mating", "counterpart.nc");
    private static readonly string[] Dialect = ["--dialect", "delta-nc300"];
    private static readonly string[] Blocks = ["--blocks", "N130..N160", "--normal", "0.02"];

    [Theory]
    [InlineData("check")]
    [InlineData("motion")]
    [InlineData("locate", "--blocks", "N130")]
    public void A_program_from_standard_input_is_read_as_from_its_file(params string[] words)
    {
        var (exit, output, error, _) = Run(File.ReadAllBytes(Program), ["nc", words[0], "-", .. words[1..], .. Dialect]);
        var named = Shell.Run(["nc", words[0], Program, .. words[1..], .. Dialect]);
        Assert.Equal((0, ""), (exit, error));
        Assert.Equal(named.Output.Replace(Program, "standard input", StringComparison.Ordinal), output);
    }

    [Fact]
    public void A_displaced_program_goes_to_standard_output_and_nothing_else_does()
    {
        using var folder = new TemporaryFolder();
        var file = Path.Combine(folder.Path, "displaced.nc");
        Assert.Equal(0, Shell.Run(["nc", "displace", Program, .. Dialect, .. Blocks, "--out", file]).Exit);
        var (exit, output, error, program) = Run(File.ReadAllBytes(Program), ["nc", "displace", "-", .. Dialect, .. Blocks, "--out", "-"]);
        Assert.Equal((0, ""), (exit, output));
        Assert.Equal(File.ReadAllBytes(file), program);
        Assert.StartsWith("standard output: ", error, StringComparison.Ordinal);
        Assert.Contains("Proof holds: ", error, StringComparison.Ordinal);
    }

    [Fact]
    public void Bytes_that_are_no_UTF_8_pass_unchanged()
    {
        var latin = Encoding.Latin1.GetBytes("(Gehäuse)\r\nN10 G1 X1. Y0. F100.\r\nN20 X2.\r\nM30\r\n");
        var (exit, _, _, program) = Run(latin, ["nc", "displace", "-", "--blocks", "N20", "--by", "0,0.5", "--out", "-"]);
        Assert.Equal(0, exit);
        Assert.Equal("(Gehäuse)\r\nN10 G1 X1. Y0. F100.\r\nN20 X2. Y0.5\r\nM30\r\n", Encoding.Latin1.GetString(program));
    }

    [Fact]
    public void A_refused_program_leaves_standard_output_empty()
    {
        var (exit, output, error, program) = Run(
            File.ReadAllBytes(Program), ["nc", "displace", "-", .. Dialect, "--blocks", "N99999", "--normal", "0.02", "--out", "-"]);
        Assert.Equal((2, "", 0), (exit, output, program.Length));
        Assert.StartsWith("standard input: ", error, StringComparison.Ordinal);
    }

    [Fact]
    public void A_proof_has_its_result_from_standard_input()
    {
        var proof = Repository.PathTo("samples", "proof");
        var after = File.ReadAllBytes(Path.Combine(proof, "displaced.nc"));
        var (exit, output, error, _) = Run(after, ["nc", "prove", Program, "-", "--wish", Path.Combine(proof, "wish.json")]);
        Assert.Equal((0, ""), (exit, error));
        Assert.StartsWith("standard input is ", output, StringComparison.Ordinal);
        (exit, output, _, _) = Run(after, ["nc", "diff", Program, "-", .. Dialect, "--json"]);
        Assert.Equal(0, exit);
        Assert.Contains("\"standard input\"", output, StringComparison.Ordinal);
    }

    [Fact]
    public void Points_come_from_standard_input()
    {
        var points = Encoding.UTF8.GetBytes("x,y\n0,1\n1,3\n2,5\n");
        var (exit, output, _, _) = Run(points, ["fit", "line", "-"]);
        Assert.Equal(0, exit);
        Assert.StartsWith("Line", output, StringComparison.Ordinal);
        Assert.Contains("3 points of standard input", output, StringComparison.Ordinal);
        (exit, _, var error, _) = Run(Encoding.UTF8.GetBytes("x,y\n0,oops\n"), ["fit", "line", "-"]);
        Assert.Equal(1, exit);
        Assert.StartsWith("standard input:2:2: ", error, StringComparison.Ordinal);
    }

    [Fact]
    public void Measurements_come_from_standard_input()
    {
        var mating = Repository.PathTo("samples", "complex-mating");
        string At(string name) => Path.Combine(mating, name);
        var expected = Shell.Run(["verify", At("job.json"), "--before", At("counterpart.csv"), "--after", At("counterpart-after.csv")]);
        var verified = Run(
            File.ReadAllBytes(At("counterpart-after.csv")), ["verify", At("job.json"), "--before", At("counterpart.csv"), "--after", "-"]);
        Assert.Equal((0, expected.Output), (verified.Exit, verified.Output));

        var job = Repository.PathTo("samples", "surface-one", "job.json");
        var after = Repository.PathTo("samples", "surface-one", "after.csv");
        var evaluated = Run(File.ReadAllBytes(after), ["surface", "evaluate", job, "--measured", "-"]);
        Assert.Equal(
            Shell.Run(["surface", "evaluate", job, "--measured", after]).Output.Replace(after, "standard input", StringComparison.Ordinal),
            evaluated.Output);
    }

    [Theory]
    [InlineData("- names standard input more than once", "nc", "diff", "-", "-")]
    [InlineData(
        "--json and --out - both need standard output",
        "nc", "displace", "-", "--blocks", "N1", "--normal", "1", "--out", "-", "--json")]
    public void A_stream_has_one_use(string problem, params string[] words)
    {
        var (exit, output, error, _) = Run([], words);
        Assert.Equal(1, exit);
        Assert.Contains(problem, output + error, StringComparison.Ordinal);
    }

    [Fact]
    public void What_is_too_large_or_cannot_be_read_is_refused()
    {
        var refusal = Assert.Single(
            Assert.Throws<ErrorMatching.Refusals.InputException>(
                () => new StandardInput(() => new MemoryStream(new byte[11])).Read(10, "program-too-large")).Refusals);
        Assert.Equal(("program-too-large", "standard input"), (refusal.Code, refusal.Place.File));
        Assert.Equal(10, new StandardInput(() => new MemoryStream(new byte[10])).Read(10, "program-too-large").Length);
        refusal = Assert.Single(
            Assert.Throws<ErrorMatching.Refusals.InputException>(
                () => new StandardInput(() => throw new IOException("Broken pipe")).Read(10, "program-too-large")).Refusals);
        Assert.Equal("file-unreadable", refusal.Code);
    }

    [Fact]
    public void Warnings_verdicts_and_errors_have_color_on_a_terminal_alone()
    {
        using var shown = new StringWriter();
        var page = new Page(shown, hasColor: true);
        page.Warning("dull tool");
        page.Verdict("Cut it.", isGood: true);
        page.Verdict("Do not cut it.", isGood: false);
        page.Verdict("It is not judged.", isGood: null);
        page.Error("wrong");
        Assert.Equal(
            "\u001b[1m\u001b[33mWarning:\u001b[0m dull tool\n\u001b[1m\u001b[32mCut it.\u001b[0m\n"
                + "\u001b[1m\u001b[31mDo not cut it.\u001b[0m\n\u001b[1mIt is not judged.\u001b[0m\n\u001b[31mwrong\u001b[0m\n",
            shown.ToString());
        using var plain = new StringWriter();
        page = new Page(plain, hasColor: false);
        page.Warning("dull tool");
        page.Verdict("Cut it.", isGood: true);
        page.Error("wrong");
        Assert.Equal("Warning: dull tool\nCut it.\nwrong\n", plain.ToString());
    }

    [Fact]
    public void An_error_has_the_color_of_standard_error_whatever_becomes_of_the_output()
    {
        using var error = new StringWriter();
        var terminal = new Terminal(TextWriter.Null, error, HasColor: false) { HasErrorColor = true };
        Assert.Equal(1, Application.Run(["nc", "check", "not-there.nc"], terminal, TestContext.Current.CancellationToken));
        Assert.StartsWith("\u001b[31m", error.ToString(), StringComparison.Ordinal);
    }

    private static (int Exit, string Output, string Error, byte[] Program) Run(byte[] input, IReadOnlyList<string> words)
    {
        using var output = new StringWriter { NewLine = "\n" };
        using var error = new StringWriter { NewLine = "\n" };
        using var program = new MemoryStream();
        var terminal = new Terminal(output, error, HasColor: false)
        {
            Input = new(() => new MemoryStream(input)),
            ProgramOutput = () => program,
        };
        var exit = Application.Run(words, terminal, TestContext.Current.CancellationToken);
        return (exit, output.ToString(), error.ToString(), program.ToArray());
    }
}
