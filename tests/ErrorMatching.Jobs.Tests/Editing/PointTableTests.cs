using ErrorMatching.Mating;
using ErrorMatching.Testing;

namespace ErrorMatching.Jobs.Tests;

public sealed class PointTableTests
{
    private static readonly MatingDraft Draft = new()
    {
        Features = [
            new() { Name = "L", Flanks = [[new("1"), new("2")]] },
            new() { Name = "C", Flanks = [[new("3"), new("4", "9", "9"), new("5")]] }]
    };

    // Its points have coordinates: their labels are those of the job.
    private static MatingDraft Known => PointTable.Read("1\t0\t0\n2\t0\t0\n3\t0\t0\n5\t0\t0").Into(Draft).Draft;

    [Theory]
    [InlineData("point\tx\ty\r\n1\t-31.95\t76.008\r\n3\t+1\t2\r\n")]
    [InlineData("1;-31,95;76,008\n3;+1;2")]
    [InlineData("point,x_mm,y_mm\n\"1\", -31.95 ,76.008\n3,+1,2\n\n")]
    public void Labels_say_whose_coordinates_they_are(string text)
    {
        var table = PointTable.Read(text);
        Assert.Equal(2, table.Count);
        Assert.Equal(
            [("1", "-31.95", "76.008"), ("2", "0", "0"), ("3", "+1", "2"), ("4", "9", "9"), ("5", "0", "0")],
            table.Into(Known).Draft.Points.Select(p => (p.Label, p.X, p.Y)));
    }

    [Fact]
    public void Without_labels_they_go_by_the_order_of_the_points() =>
        Assert.Equal(
            ["1 2", "3 4", "5 6", "7 8", "9 10"],
            PointTable.Read("1\t2\n3\t4\n5\t6\n7\t8\n9\t10").Into(Draft).Draft.Points.Select(p => $"{p.X} {p.Y}"));

    [Theory]
    [InlineData(4)]
    [InlineData(6)]
    public void Without_labels_nobody_knows_which_row_is_missing_or_too_many(int rows)
    {
        var taken = PointTable.Read(string.Join('\n', Enumerable.Range(0, rows).Select(r => $"{r}\t0"))).Into(Draft);
        Assert.Equal((PointTableRefusal.NoLabels, rows, 5), (taken.Refusal, taken.Rows, taken.Points));
        Assert.Same(Draft, taken.Draft);
    }

    [Fact]
    public void A_label_that_no_feature_has_is_another_point() =>
        Assert.Equal([new PointDraft("O", "0", "0", "5")], PointTable.Read("O\t0\t0\t5\n1\t1\t1\t5").Into(Known).Draft.OtherPoints);

    [Fact]
    public void A_whole_table_gives_its_labels_to_points_that_have_no_coordinates_yet()
    {
        var counted = Draft with
        {
            Features = [new() { Name = "L", Flanks = [[new("1"), new("2")]] }, new() { Name = "C", Flanks = [[new("3")]] }]
        };
        var taken = PointTable.Read("A\t1\t2\n2a\t3\t4\n3\t5\t6").Into(counted);
        Assert.True(taken.HasNewLabels);
        Assert.Equal([("A", "1"), ("2a", "3"), ("3", "5")], taken.Draft.Points.Select(p => (p.Label, p.X)));

        // A point with a coordinate keeps its label, the others take what is left; the same labels go by label in any order.
        var begun = counted with { Features = [counted.Features[0], new() { Name = "C", Flanks = [[new("3", "9")]] }] };
        Assert.Equal(
            [("A", "1"), ("2a", "2"), ("3", "5")],
            PointTable.Read("3\t5\t6\nA\t1\t2\n2a\t2\t4").Into(begun).Draft.Points.Select(p => (p.Label, p.X)));
        taken = PointTable.Read("3\t3\t0\n2\t2\t0\n1\t1\t0").Into(counted);
        Assert.False(taken.HasNewLabels);
        Assert.Equal([("1", "1"), ("2", "2"), ("3", "3")], taken.Draft.Points.Select(p => (p.Label, p.X)));
    }

    [Fact]
    public void Numbers_of_a_count_are_not_taken_for_the_labels_of_a_drawing()
    {
        // The paper's drawing has a tip of no feature in its middle; a line, a triangle and a curve were counted from 1 to 16.
        var drawing = File.ReadAllText(Repository.PathTo("samples", "complex-mating", "theoretical.csv"));
        var counted = new FeatureKind[]
        {
            LineKind.Instance,
            TriangleKind.Instance,
            CurveKind.Instance
        }.Aggregate(
            new MatingDraft(), (d, k) => d with { Features = [.. d.Features, FeatureDraft.New(k, k.ToString(), d)] }).WithPoints(2, 0, 10);
        var refused = PointTable.Read(drawing).Into(counted);
        Assert.Equal((PointTableRefusal.OtherCount, 17, 16), (refused.Refusal, refused.Rows, refused.Points));
        Assert.Equal("2a 3a 3b | 15 16", $"{string.Join(' ', refused.OnlyInTable)} | {string.Join(' ', refused.OnlyInFeatures)}");
        Assert.Same(counted, refused.Draft);

        // Fewer points, whose numbers all stand in it; a part of the table;
        // and one point that was typed, by the number that is the tip's there.
        Assert.Equal(
            PointTableRefusal.OtherCount, PointTable.Read(drawing).Into(counted with { Features = [.. counted.Features.Take(2)] }).Refusal);
        Assert.Equal(PointTableRefusal.OtherCount, PointTable.Read(string.Join('\n', drawing.Split('\n').Skip(8))).Into(counted).Refusal);
        Assert.Equal(
            PointTableRefusal.OtherCount,
            PointTable.Read(drawing).Into(counted.WithFeature(
                1, f => f with { Flanks = [[new("3", "1"), f.Flanks[0][1]], f.Flanks[1]] })).Refusal);

        // With the tip as a point of no feature there is a row for each point, in the order of cutting.
        var taken = PointTable.Read(drawing).Into(counted with { OtherPoints = [new("3")] });
        Assert.Equal(
            (PointTableRefusal.None, true, 0, 0), (taken.Refusal, taken.HasNewLabels, taken.OnlyInTable.Count, taken.OnlyInFeatures.Count));
        var sample = MatingDraftFiles.Open(Repository.PathTo("samples", "complex-mating", "job.json"));
        Assert.Equal(sample.Points.Select(p => (p.Label, p.X, p.Y)), taken.Draft.Points.Select(p => (p.Label, p.X, p.Y)));

        // So it is where the points were named as the drawing names them.
        var named = counted.WithRows((i, _) => new(sample.Points.ElementAt(i).Label, "", ""));
        taken = PointTable.Read(drawing).Into(named);
        Assert.Equal(["3"], taken.OnlyInTable);
        Assert.False(taken.HasNewLabels);
        Assert.Equal(sample.Points.Select(p => (p.Label, p.X, p.Y)), taken.Draft.Points.Select(p => (p.Label, p.X, p.Y)));
    }

    [Fact]
    public void Before_there_are_points_nothing_is_taken()
    {
        Assert.Equal(PointTableRefusal.NoFeatures, PointTable.Read("1\t2\t3").Into(new()).Refusal);
        Assert.Equal(
            PointTableRefusal.NoFeatures,
            PointTable.Read("1\t2\t3").Into(new() { Features = [new() { Name = "L" }], OtherPoints = [new("1")] }).Refusal);
        Assert.Empty(PointTable.Read("1\t2\t3").Into(new()).Draft.Points);
    }

    [Fact]
    public void A_label_that_stands_there_twice_is_named_and_nothing_is_taken()
    {
        var taken = PointTable.Read("1\t1\t1\n2\t1\t1\n2\t2\t2").Into(Known);
        Assert.Equal(PointTableRefusal.LabelTwice, taken.Refusal);
        Assert.Equal(["2"], taken.OnlyInTable);
        Assert.True(Known.IsSame(taken.Draft));
    }

    [Fact]
    public void What_table_and_points_do_not_have_in_common_is_named()
    {
        Assert.Equal("O | 2 3 4 5", Differences("O\t0\t0\n1\t1\t1", Known));

        // A point of no feature that is there already is none to ask about; whole tables have everything in common.
        Assert.Equal(" | 2 3 4 5", Differences("O\t0\t0\n1\t1\t1", Known with { OtherPoints = [new("O")] }));
        Assert.Equal(
            " | ", Differences("A\t1\t2\n2a\t3\t4", Draft with { Features = [new() { Name = "L", Flanks = [[new("1"), new("2")]] }] }));

        // Points that wait for their coordinates go on waiting where a table has nothing for them.
        Assert.Equal(
            " | 6 7",
            Differences(
                "1\t1\t1\n2\t1\t1\n3\t1\t1\n4\t1\t1\n5\t1\t1",
                Known with { Features = [.. Known.Features, new() { Name = "D", Flanks = [[new("6"), new("7")]] }] }));

        static string Differences(string text, MatingDraft draft)
        {
            var taken = PointTable.Read(text).Into(draft);
            Assert.Equal(PointTableRefusal.None, taken.Refusal);
            return $"{string.Join(' ', taken.OnlyInTable)} | {string.Join(' ', taken.OnlyInFeatures)}";
        }
    }

    [Theory]
    [InlineData("")]
    [InlineData("hello")]
    [InlineData("a\tb\tc\nd\te\tf")]
    [InlineData("1\t2\t3\t4\t5")]
    [InlineData("1e999\t2")]
    public void What_has_no_coordinates_changes_nothing(string text)
    {
        Assert.Equal(0, PointTable.Read(text).Count);
        Assert.True(Draft.IsSame(PointTable.Read(text).Into(Draft).Draft));
    }

    [Theory]
    [InlineData("point,x,y\n1,-31.95,76.008\n2,-32.3O,58\n3,1,2\n", 3, "2,-32.3O,58")]
    [InlineData("1;-31,95O;76,008\n3;+1;2", 1, "1;-31,95O;76,008")]
    [InlineData("1\t-31.95\t76\n\n# measured twice\n3\n", 4, "3")]
    [InlineData("1\t2\t3\n4\t5\n", 2, "4\t5")]
    [InlineData("1\t2\t3\n\t4\t5\n", 2, "\t4\t5")]
    [InlineData("1,0,0,0\n2,x,1,2\n", 2, "2,x,1,2")]
    public void A_line_that_cannot_be_read_is_named_and_nothing_is_taken(string text, int line, string words)
    {
        var table = PointTable.Read(text);
        Assert.Equal(new PointTableFault(line, words), table.Fault);
        Assert.Equal(0, table.Count);
        Assert.True(Draft.IsSame(table.Into(Draft).Draft));
    }

    [Fact]
    public void Headings_of_several_lines_are_none_of_the_points() =>
        Assert.Equal(1, PointTable.Read("Housing;\nRev 2;4711\nlabel;x;y\n;;\n1;2;3\n").Count);
}
