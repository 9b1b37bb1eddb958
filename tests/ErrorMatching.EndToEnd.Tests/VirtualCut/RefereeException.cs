namespace ErrorMatching.EndToEnd.Tests;

/// <summary>The referee cannot judge: a program it does not understand, or a place where nothing was cut.</summary>
internal sealed class RefereeException(string message) : Exception(message);
