namespace ErrorMatching.Cell;

/// <summary>A gauge's folder cannot be read.</summary>
/// <param name="message">A sentence for a setter: gauge, folder, the error, what to do next.</param>
/// <param name="cause">The underlying error; null if there is none.</param>
public sealed class SourceException(string message, Exception? cause = null) : Exception(message, cause);
