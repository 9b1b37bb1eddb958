using ErrorMatching.Freeform;
using ErrorMatching.Geometry;
using ErrorMatching.Json;
using ErrorMatching.Mating;
using ErrorMatching.Measurement;
using ErrorMatching.Nc;

namespace ErrorMatching.Jobs.Tests;

public sealed class ErrorItemsTests
{
    private static readonly JsonProblem Problem = new(
        "no-such-key", "$.nmae", new(3, 5), "the key nmae", "one of name", "found the key nmae; expected one of name");

    [Fact]
    public void Each_exception_of_an_input_has_a_code_and_a_place()
    {
        (Exception, string, string?, int?)[] expected =
        [
            (new MeasurementException("not-a-number", "NaN", "a number", "p.csv", 4, 2), "not-a-number", "p.csv", 4),
            (new FreeformException("unknown-entity", "s.igs", "no such surface", 7), "unknown-entity", "s.igs", 7),
            (new JobException("job.json", [Problem]), "no-such-key", "job.json", 3),
            (new JsonDocumentException("dialect.json", [Problem]), "no-such-key", "dialect.json", 3),
            (new PointsException("p.csv", new GeometryException(GeometryError.NearParallel, "no corner")), "near-parallel", "p.csv", null),
            (new WrongPieceException("p.csv", SourceSide.Part), "wrong-piece", "p.csv", null),
            (new InputException("job.json", "cannot be opened", new IOException()), "file-unreadable", "job.json", null),
            (
                new InputException("s.igs", "cannot be opened", new IOException()) { NamedAt = new("job.json", "$.surface", new(4, 14)) },
                "file-unreadable",
                "job.json",
                4),
            (new NcException(NcErrorCode.BadSelector, "no selector"), "bad-selector", null, null),
        ];
        foreach (var (exception, code, file, line) in expected)
        {
            var item = Assert.Single(ErrorItems.OfInput(exception)!);
            Assert.Equal((code, file, line), (item.Code, item.File, item.Line));
            Assert.NotEmpty(item.Message);
        }
    }

    [Fact]
    public void All_problems_of_a_document_are_named() =>
        Assert.Equal(2, ErrorItems.OfInput(new JobException("job.json", [Problem, Problem]))!.Count);

    [Fact]
    public void A_question_ends_in_one_mark() => Assert.EndsWith(
        "did you mean \"name\"?",
        Assert.Single(
            ErrorItems.OfInput(new JsonDocumentException("job.json", [Problem with { Message = "the key nmae; did you mean \"name\"?" }]))!)
            .Problem,
        StringComparison.Ordinal);

    // The text form puts file and line in front: a block that is named by its line must not say it again.
    [Fact]
    public void A_line_that_stands_in_the_place_does_not_stand_in_the_problem()
    {
        var items = ErrorItems.Of(
            [
                new NcRefusal("no-good", "line 3", 3, "line 3: no good"),
                new NcRefusal("no-good", "N30", 3, "N30: no good"),
                new NcRefusal("no-good", "line 30", 3, "line 30: no good")],
            "p.nc");
        Assert.Equal(["no good", "N30: no good", "line 30: no good"], items.Select(i => i.Problem));
        Assert.Equal("p.nc: line 3: no good", items[0].Message);
    }

    [Fact]
    public void A_defect_is_no_error_of_an_input()
    {
        Assert.Null(ErrorItems.OfInput(new InvalidOperationException()));
        Assert.Null(ErrorItems.OfInput(new OperationCanceledException()));
        Assert.Null(ErrorItems.OfInput(new OutputException(OutputException.Unwritable, "f", "m")));
        Assert.Null(ErrorItems.OfInput(new IOException()));
    }

    [Fact]
    public void Each_error_of_geometry_and_of_programs_has_a_code_of_its_own()
    {
        var codes = Enum.GetValues<GeometryError>().Select(e => ErrorItems.Of(new GeometryException(e, "m"), "f").Code).ToArray();
        Assert.Equal(codes.Length, codes.Distinct().Count());
        var ofPrograms = Enum.GetValues<NcErrorCode>().Select(e => ErrorItems.Of(new NcException(e, "m")).Code).ToArray();
        Assert.Equal(ofPrograms.Length, ofPrograms.Distinct().Count());
    }
}
