using System.Collections.Concurrent;

namespace ErrorMatching.Cell;

/// <summary>Reads a sequence on a second core, some pages ahead of its consumer. Memory stays flat, whatever the length.</summary>
internal static class ReadAhead
{
    private const int PageLength = 1024;
    private const int MostPages = 8;

    /// <summary>The elements, in their order.</summary>
    public static IEnumerable<T> Of<T>(IEnumerable<T> elements)
    {
        using var pages = new BlockingCollection<T[]>(MostPages);
        using var stop = new CancellationTokenSource();
        var reading = Task.Run(() => Read(elements, pages, stop.Token));
        try
        {
            foreach (var page in pages.GetConsumingEnumerable())
            {
                foreach (var element in page) yield return element;
            }
        }
        finally
        {
            // The reader has a connection open: it must have ended before others use that.
            stop.Cancel();
            reading.ContinueWith(_ => { }, CancellationToken.None, TaskContinuationOptions.None, TaskScheduler.Default).Wait();
        }

        reading.GetAwaiter().GetResult();
    }

    private static void Read<T>(IEnumerable<T> elements, BlockingCollection<T[]> pages, CancellationToken stop)
    {
        try
        {
            foreach (var page in elements.Chunk(PageLength)) pages.Add(page, stop);
        }
        catch (OperationCanceledException) when (stop.IsCancellationRequested)
        {
            // The consumer has seen enough.
        }
        finally
        {
            pages.CompleteAdding();
        }
    }
}
