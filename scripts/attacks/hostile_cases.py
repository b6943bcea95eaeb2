"""How the game of each hostile team must end: one outcome for each, so that a forfeit for another reason is a failure, too."""

# Harms nobody: the game is played to its end.
FINISHED = {"slow_connect", "slow_hello", "pauses", "lingers", "crash_at_end", "requests", "backtick_name", "bidi_name", "longest_name",
            "largest_frame", "closes_output", "prints", "forks", "daemons", "hidden_daemon", "many_files", "fills_folder", "odd_files",
            "not_numbers", "no_such_robots", "leaves_key"}
# Aimed at others: who is isolated does not reach them, and the game is played. Without isolation it may go either way.
OUT_OF_REACH = {"kills_other_team", "stops_other_team", "kills_runner", "stops_host", "kills_all", "kills_parent", "traces_others",
                "visits_early", "visits_others", "removes_socket", "writes_ledger", "removes_results", "forges_ledger",
                "sets_sysctl", "mounts_groups"}
FORFEITS = {
    "not-connected": {"never_connects"},
    "not-responding": {"silent_at_hello", "silent_after_hello", "half_hello", "half_length", "silent", "cut", "drips", "stops_itself",
                       "vfork", "connects_twice"},  # the last plays where nobody listens
    "crashed": {"crash", "crash_at_start", "crash_connected", "crash_at_hello", "abort", "forks_and_crash", "daemons_and_crash",
                "prints_escapes", "long_line"},
    "closed": {"exit", "exit_at_start", "exit_connected", "exit_at_hello", "closes", "shuts_writing", "becomes_another"},
    "nonsense": {"nonsense", "noise", "old_tick", "next_tick", "least_tick", "greatest_tick", "two_replies", "no_reply", "hello_again",
                 "reply_first", "old_version", "new_version", "bad_keeper", "great_keeper", "great_name", "name_of_100_kb", "long_name",
                 "escape_name", "no_utf8_name", "great_notes", "unknown_fields", "empty_commands", "same_robot", "too_large",
                 "just_too_large", "too_large_hello", "greatest_length", "endless_length", "groups", "never_reads", "flood",
                 "flood_of_nothing", "connects_again"},
    "over-limit": {"slow_second", "slow_ticks", "busy_ticks", "gigabytes", "eats_memory", "memfd", "unlinked",
                   "many_processes", "fork_bomb"},
    "stood-still": {"never_moves"},
}
FAKES = {"flood": "nonsense", "burst": "over-limit", "memory": "over-limit", "gigabytes": "over-limit", "endless": "nonsense",
         "ignore-term": "not-responding"}  # of tests/fakes

# These are given the usual 20 s of own time for a simulated second, so that what ends them is the 5 s of a reply, or what they print.
PATIENT = {"silent", "silent_after_hello", "cut", "half_length", "drips", "stops_itself", "vfork", "gigabytes", "fake gigabytes",
           "fake ignore-term"}


def outcomes():
    """{mode: how its game must end}"""
    found = {mode: "finished" for mode in FINISHED | OUT_OF_REACH}
    for termination, modes in FORFEITS.items():
        found |= {mode: termination for mode in modes}
    return found | {"fake " + mode: termination for mode, termination in FAKES.items()}
