namespace ErrorMatching.Jobs.Tests;

public sealed class PointTableTests
{
    private static readonly MatingDraft Draft = new() { Features = [new() { Name = "L", Flanks = [[new("1"), new("2")]] }, new() { Name = "C", Flanks = [[new("3"), new("4", "9", "9"), new("5")]] }] };

    [Theory]
    [InlineData("point\tx\ty\r\n1\t-31.95\t76.008\r\n3\t+1\t2\r\n")]
    [InlineData("1;-31,95;76,008\n3;+1;2")]
    [InlineData("point,x_mm,y_mm\n\"1\", -31.95 ,76.008\n3,+1,2\n\n")]
    public void Labels_say_whose_coordinates_they_are(string text)
    {
        var table = PointTable.Read(text);
        Assert.Equal(2, table.Count);
        Assert.Equal([("1", "-31.95", "76.008"), ("2", "", ""), ("3", "+1", "2"), ("4", "9", "9"), ("5", "", "")], table.Into(Draft).Points.Select(p => (p.Label, p.X, p.Y)));
    }

    [Fact]
    public void Without_labels_they_go_by_the_order_of_the_points() =>
        Assert.Equal(["1 2", "3 4", "5 6", "9 9", " "], PointTable.Read("1\t2\n3\t4\n5\t6\n").Into(Draft).Points.Select(p => $"{p.X} {p.Y}"));

    [Fact]
    public void A_label_that_no_feature_has_is_another_point() =>
        Assert.Equal([new PointDraft("O", "0", "0", "5")], PointTable.Read("O\t0\t0\t5\n1\t1\t1\t5").Into(Draft).OtherPoints);

    [Fact]
    public void A_whole_table_gives_its_labels_to_points_that_have_no_coordinates_yet()
    {
        var counted = Draft with { Features = [new() { Name = "L", Flanks = [[new("1"), new("2")]] }, new() { Name = "C", Flanks = [[new("3")]] }] };
        var table = PointTable.Read("A\t1\t2\n2a\t3\t4\n3\t5\t6");
        Assert.Equal([("A", "1"), ("2a", "3"), ("3", "5")], table.Into(counted).Points.Select(p => (p.Label, p.X)));

        // With one coordinate it is a table like any other, and so it is with the same labels in another order.
        var begun = counted with { Features = [counted.Features[0], new() { Name = "C", Flanks = [[new("3", "9")]] }] };
        Assert.Equal([("1", ""), ("2", ""), ("3", "5"), ("A", "1"), ("2a", "3")], table.Into(begun).Points.Select(p => (p.Label, p.X)));
        Assert.Equal([("1", "1"), ("2", "2"), ("3", "3")], PointTable.Read("3\t3\t0\n2\t2\t0\n1\t1\t0").Into(counted).Points.Select(p => (p.Label, p.X)));
    }

    [Fact]
    public void What_table_and_features_do_not_have_in_common_is_named()
    {
        Assert.Equal("O | 2 3 4 5", Differences("O\t0\t0\n1\t1\t1", Draft));
        Assert.Equal(" | 5", Differences("1\t2\n3\t4\n5\t6\n7\t8", Draft));
        Assert.Equal("6 7 | ", Differences("1\t1\n1\t1\n1\t1\n1\t1\n1\t1\n1\t1\n1\t1", Draft));

        // A whole table gives its labels.
        var counted = Draft with { Features = [new() { Name = "L", Flanks = [[new("1"), new("2")]] }] };
        Assert.Equal(" | ", Differences("A\t1\t2\n2a\t3\t4", counted));

        static string Differences(string text, MatingDraft draft)
        {
            var (other, missing) = PointTable.Read(text).Differences(draft);
            return $"{string.Join(' ', other)} | {string.Join(' ', missing)}";
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
        Assert.True(Draft.IsSame(PointTable.Read(text).Into(Draft)));
    }

    [Theory]
    [InlineData("point,x,y\n1,-31.95,76.008\n2,-32.3O,58\n3,1,2\n", 3, "2,-32.3O,58")]
    [InlineData("1;-31,95O;76,008\n3;+1;2", 1, "1;-31,95O;76,008")]
    [InlineData("1\t-31.95\t76\n\n# measured twice\n3\n", 4, "3")]
    [InlineData("1\t2\t3\n4\t5\n", 2, "4\t5")]
    [InlineData("1,0,0,0\n2,x,1,2\n", 2, "2,x,1,2")]
    public void A_line_that_cannot_be_read_is_named_and_nothing_is_taken(string text, int line, string words)
    {
        var table = PointTable.Read(text);
        Assert.Equal(new PointTableFault(line, words), table.Fault);
        Assert.Equal(0, table.Count);
        Assert.True(Draft.IsSame(table.Into(Draft)));
    }

    [Fact]
    public void Headings_of_several_lines_are_none_of_the_points() =>
        Assert.Equal(1, PointTable.Read("Housing;\nRev 2;4711\nlabel;x;y\n;;\n1;2;3\n").Count);
}
