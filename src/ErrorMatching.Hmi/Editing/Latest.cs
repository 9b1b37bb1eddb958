namespace ErrorMatching.Hmi;

/// <summary>Runs work off the UI thread on the latest input; newer input replaces pending input.</summary>
/// <typeparam name="T">Type of the input.</typeparam>
/// <param name="work">The work. It must report its own failures; an unhandled exception ends the program.</param>
internal sealed class Latest<T>(Action<T> work)
    where T : class
{
    private readonly Lock _gate = new();
    private T? _next;
    private bool _isRunning;

    /// <summary>Completes when nothing is pending or running.</summary>
    public Task Running { get; private set; } = Task.CompletedTask;

    /// <summary>Adds input. Call it on the UI thread.</summary>
    public void Give(T item)
    {
        lock (_gate)
        {
            _next = item;
            if (_isRunning)
            {
                return;
            }

            _isRunning = true;
        }

        Running = Task.Run(Work).Watched();
    }

    private void Work()
    {
        while (true)
        {
            T item;
            lock (_gate)
            {
                if (_next is null)
                {
                    _isRunning = false;
                    return;
                }

                (item, _next) = (_next, null);
            }

            work(item);
        }
    }
}
