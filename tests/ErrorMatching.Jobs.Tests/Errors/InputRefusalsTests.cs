using ErrorMatching.Geometry;
using ErrorMatching.Measurement;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs.Tests;

public sealed class InputRefusalsTests
{
    private static readonly Refusal Problem =
        Refusal.Of("no-such-key", "the key nmae", "one of name", new() { Line = 3, Column = 5, Path = "$.nmae" });

    [Fact]
    public void Each_exception_of_an_input_has_a_code_a_place_and_a_sentence_with_it()
    {
        var unopened = InputException.At("file-unreadable", "s.igs", "s.igs cannot be opened.");
        (InputException, string, string?, int?, string)[] expected =
        [
            (
                MeasurementRefusal.Of("not-a-number", "NaN", "a number", "p.csv", 4, 2),
                "not-a-number", "p.csv", 4, "p.csv, line 4, column 2: found NaN; expected a number."),
            (InputException.At("bad-log", "s.igs", "no point.", 7), "bad-log", "s.igs", 7, "s.igs, line 7: no point."),
            (
                new InputException("job.json", [Problem]),
                "no-such-key", "job.json", 3, "job.json, line 3, column 5, $.nmae: found the key nmae; expected one of name."),
            (
                InputRefusals.Of(new GeometryException(GeometryError.NearParallel, "no corner."), "p.csv"),
                "near-parallel", "p.csv", null, "p.csv: no corner."),
            (
                InputRefusals.WrongPiece("p.csv", SourceSide.Part),
                "wrong-piece", "p.csv", null,
                "p.csv: found a measurement of the counterpart by the job's rules of recognition; expected one of the part."),
            (unopened, "file-unreadable", "s.igs", null, "s.igs cannot be opened."),
            (
                InputRefusals.NamedAt("job.json", "$.surface", new(4, 14), unopened),
                "file-unreadable", "job.json", 4, "job.json, line 4, column 14, $.surface: s.igs cannot be opened."),
            (
                new InputException(new Refusal(NcInputCodes.BadSelector, "no selector.")),
                "bad-selector", null, null, "no selector."),
        ];
        foreach (var (exception, code, file, line, sentence) in expected)
        {
            Assert.Equal(
                (code, file, line, sentence), (exception.Code, exception.File, exception.Place.Line, exception.Refusals[0].Sentence));
            Assert.Equal(sentence, exception.Message);
        }
    }

    [Fact]
    public void All_problems_of_a_document_are_named()
    {
        var error = new InputException("job.json", [Problem, Problem with { Code = "other" }]);
        Assert.Equal(["no-such-key", "other"], error.Refusals.Select(r => r.Code));
        Assert.Equal(2, error.Message.Split('\n').Length);
    }

    [Fact]
    public void A_refusal_of_a_block_concerns_the_program_and_any_other_the_job()
    {
        var refusals = InputRefusals.Of(
            [
                new("no-good", "N30: no good.", new() { Block = "N30", Line = 3 }),
                new("no-good", "No block is numbered N7.", new() { Block = "N7" }),
                new("no-good", "too wide.", new() { Path = "$.features[0].toleranceMm", Line = 8, Column = 2 }),
                new("no-good", "all of it."),
                new("no-good", "named already.", new() { File = "p.csv" }),
            ],
            "job.json",
            "p.nc");
        Assert.Equal(["p.nc", "p.nc", "job.json", "job.json", "p.csv"], refusals.Select(r => r.Place.File));
        Assert.Equal("p.nc: N30: no good.", refusals[0].Sentence);
    }

    [Fact]
    public void An_outcome_is_usable_or_says_why()
    {
        Outcome<string> usable = "result";
        Outcome<string> refused = Problem;
        Assert.Equal((true, "result", null, 0), (usable.IsUsable, usable.Result, usable.Refusal, usable.Refusals.Count));
        Assert.Equal((false, null, Problem, 1), (refused.IsUsable, refused.Result, refused.Refusal, refused.Refusals.Count));
        Assert.Throws<ArgumentException>(() => Outcome.Refused<string>([]));
    }

    [Fact]
    public void Each_error_of_geometry_has_a_code_of_its_own()
    {
        var codes = Enum.GetValues<GeometryError>().Select(e => InputRefusals.Of(new GeometryException(e, "m"), "f").Code).ToArray();
        Assert.Equal(codes.Length, codes.Distinct().Count());
    }
}
