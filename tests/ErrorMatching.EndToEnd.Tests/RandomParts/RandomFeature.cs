namespace ErrorMatching.EndToEnd.Tests;

/// <summary>A feature of a random part: a line, a triangle (two groups of key points,
/// one a flank) or a curve (an arc or a polylined wave).</summary>
/// <param name="Name">Name, unique in the part.</param>
/// <param name="Kind">As in a job: line, triangle, curve or circle.</param>
/// <param name="Shape">What it is made of: straight, arc or wave; of a circle bore or boss.</param>
/// <param name="Blocks">The blocks that cut it, as a job names them: N120 or N120..N180.</param>
/// <param name="Groups">The key points in order of travel; two groups for a triangle, else one.</param>
internal sealed record RandomFeature(
    string Name, string Kind, string Shape, string Blocks, IReadOnlyList<IReadOnlyList<RandomKeyPoint>> Groups)
{
    /// <summary>More members of the feature in a job, each with a comma before it.</summary>
    public string More { get; init; } = "";

    public IEnumerable<RandomKeyPoint> KeyPoints => Groups.SelectMany(g => g);
}
