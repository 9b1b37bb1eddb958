namespace ErrorMatching.Hmi;

/// <summary>Work beside the screen on the latest of what it is given: what comes while it works takes the place of what waits.</summary>
/// <typeparam name="T">What it is given.</typeparam>
/// <param name="work">The work. Whatever may fail in it, it says itself: a defect in it ends the program.</param>
internal sealed class Latest<T>(Action<T> work)
    where T : class
{
    private readonly Lock _gate = new();
    private T? _next;
    private bool _isRunning;

    /// <summary>Done when nothing waits and nothing is worked on.</summary>
    public Task Running { get; private set; } = Task.CompletedTask;

    /// <summary>Gives it something. To be called on the screen's thread.</summary>
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
