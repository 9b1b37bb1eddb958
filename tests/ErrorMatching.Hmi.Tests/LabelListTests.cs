using ErrorMatching.Measurement;

namespace ErrorMatching.Hmi.Tests;

public sealed class LabelListTests
{
    [Theory]
    [InlineData("6..14", "6", "7", "8", "9", "10", "11", "12", "13", "14")]
    [InlineData("4, 6..8", "4", "6", "7", "8")]
    [InlineData("1, 2, 2a, 3a", "1", "2", "2a", "3a")]
    [InlineData("P08..P10, Q11", "P08", "P09", "P10", "Q11")]
    [InlineData("3, 2, 1", "3", "2", "1")]
    [InlineData("99999999999, 100000000000", "99999999999", "100000000000")]
    [InlineData("")]
    public void Labels_that_are_counted_on_stand_as_the_first_and_the_last(string shown, params string[] labels)
    {
        Assert.Equal(shown, LabelList.Short(labels));

        // As a job writes them: read again, they are the same.
        Assert.Equal(labels, shown.Split(", ", StringSplitOptions.RemoveEmptyEntries).SelectMany(LabelRange.Expand));
    }
}
