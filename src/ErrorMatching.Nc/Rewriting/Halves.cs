namespace ErrorMatching.Nc;

/// <summary>Long work that falls into independent parts, on two cores.</summary>
internal static class Halves
{
    /// <summary>From so many parts on, a second core is worth its start.</summary>
    public const int Many = 20_000;

    /// <summary>Does work on the first half of some parts and beside it on the second.</summary>
    /// <param name="from">The first part.</param>
    /// <param name="behind">The part behind the last.</param>
    /// <param name="work">Does the parts from one to another, which is not done; it must change nothing that both halves see.</param>
    /// <returns>What came of both halves; the same as of one after the other.</returns>
    public static (T First, T Second) Of<T>(int from, int behind, Func<int, int, T> work)
    {
        var half = from + ((behind - from) / 2);
        var second = Task.Run(() => work(half, behind));
        var first = work(from, half);
        return (first, second.GetAwaiter().GetResult());
    }

    /// <summary>The first refusal of some work on many parts, on two cores where they are many enough.</summary>
    public static NcRefusal? Refusal(int from, int behind, Func<int, int, NcRefusal?> work)
    {
        if (behind - from < Many)
        {
            return work(from, behind);
        }

        var (first, second) = Of(from, behind, work);
        return first ?? second;
    }
}
