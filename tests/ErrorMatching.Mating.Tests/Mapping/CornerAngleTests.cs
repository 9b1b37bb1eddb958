namespace ErrorMatching.Mating.Tests;

/// <summary>From which angle on a point beyond the end of its motion lies on the corner that the tool rounds:
/// where the cosine is 0.996, at 5.1 degrees.</summary>
public sealed class CornerAngleTests
{
    // The tool's circle of radius 3 about the end (50, -3): 3 (sin, cos) from it, for a cosine of 0.9961 and of 0.9959.
    [Theory]
    [InlineData("2 50.264697 -0.0117", false)]
    [InlineData("2 50.271383 -0.0123", true)]
    public void A_point_beyond_the_end_of_its_motion_is_on_the_corner_from_5_degrees_on(string point, bool isOnCorner)
    {
        var match = new MatchCase(Programs.ToolBelow) { Theoretical = $"1 10 0; {point}", Part = $"1 10 0.1; {point}" };

        Assert.Equal(isOnCorner, match.Report().Warnings.Any(w => w is { Code: "point-on-corner", Values: ["2", "N50"] }));
    }
}
