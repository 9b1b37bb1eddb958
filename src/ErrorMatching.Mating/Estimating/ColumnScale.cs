namespace ErrorMatching.Mating;

/// <summary>The scale of what is not known about errors, where only the points themselves tell it: it is not known better than they tell
/// it, so the errors follow Student's distribution.</summary>
/// <param name="Freedom">Number of independent values that tell it, 1 or more.</param>
/// <param name="Of">The factor of a column, by its number, where the true standard deviation is so many times the one that they
/// show.</param>
internal sealed record ColumnScale(int Freedom, Func<int, double, double> Of)
{
    /// <summary>Columns that all have the scale of so many points, one of which tells the mean.</summary>
    public static ColumnScale ToldBy(int points) => new(Math.Max(1, points - 1), (_, ratio) => ratio);

    /// <summary>Draws how many times the true standard deviation is the one that the values show.</summary>
    public double Draw(NormalVariates variates)
    {
        var squares = 0.0;
        for (var k = 0; k < Freedom; k++)
        {
            var variate = variates.Next();
            squares += variate * variate;
        }

        return Math.Sqrt(Freedom / squares);
    }
}
