namespace ErrorMatching.Hmi;

/// <summary>Something to choose.</summary>
/// <param name="Word">The job's word for it.</param>
/// <param name="Name">Its name on the screen.</param>
public sealed record ChoiceItem(string Word, string Name);
