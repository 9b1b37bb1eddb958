namespace ErrorMatching.EndToEnd.Tests;

/// <summary>Draws of numbers in ranges.</summary>
internal static class Draw
{
    public static double Between(Random random, double low, double high) => low + ((high - low) * random.NextDouble());

    /// <summary>A size between two bounds, with either sign.</summary>
    public static double Signed(Random random, double low, double high) => Between(random, low, high) * (random.Next(2) == 0 ? 1 : -1);

    public static bool Chance(Random random, double probability) => random.NextDouble() < probability;
}
