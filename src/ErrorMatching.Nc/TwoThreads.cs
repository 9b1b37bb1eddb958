using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>Runs long work on independent parts on two threads.</summary>
internal static class TwoThreads
{
    /// <summary>Minimum number of parts for a second thread to pay off.</summary>
    public const int Many = 20_000;

    /// <summary>Runs work on both halves of a range concurrently.</summary>
    /// <param name="from">The first part.</param>
    /// <param name="end">The part after the last.</param>
    /// <param name="work">Processes the parts from its first argument up to, not including, its second; must not change state that the
    /// other half sees.</param>
    /// <returns>The results of both halves, the same as if run one after the other.</returns>
    public static (T First, T Second) Run<T>(int from, int end, Func<int, int, T> work)
    {
        var half = from + ((end - from) / 2);
        var second = Task.Run(() => work(half, end));
        var first = work(from, half);
        return (first, second.GetAwaiter().GetResult());
    }

    /// <summary>The first refusal of work on many parts, on two threads if there are enough parts.</summary>
    public static Refusal? Refusal(int from, int end, Func<int, int, Refusal?> work)
    {
        if (end - from < Many)
        {
            return work(from, end);
        }

        var (first, second) = Run(from, end, work);
        return first ?? second;
    }
}
