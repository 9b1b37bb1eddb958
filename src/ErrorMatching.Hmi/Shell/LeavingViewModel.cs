namespace ErrorMatching.Hmi;

/// <summary>Asks whether to close the station although the edited job has changes that are not saved.</summary>
public sealed class LeavingViewModel : Observable
{
    private readonly string _job;

    /// <summary>Asks.</summary>
    /// <param name="job">The job's name.</param>
    /// <param name="close">Called if the user closes all the same.</param>
    /// <param name="stay">Called if the user continues.</param>
    public LeavingViewModel(string job, Action close, Action stay) => (_job, Close, Stay) = (job, new(close), new(stay));

    /// <summary>What is not saved, and what becomes of it.</summary>
    public string Told => Texts.Current.With("Leaving.Told", _job);

    /// <summary>Closes the station.</summary>
    public Command Close { get; }

    /// <summary>Continues.</summary>
    public Command Stay { get; }

    /// <summary>Shows it in the current language.</summary>
    internal void Translate() => OnPropertyChanged(nameof(Told));
}
