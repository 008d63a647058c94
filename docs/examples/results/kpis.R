# The same in R: means of both runs, and Student's interval of the paired difference.
library(DBI)
db <- dbConnect(RSQLite::SQLite(), commandArgs(TRUE)[1], flags = RSQLite::SQLITE_RO)
# dbExecute takes one statement at a time.
sql <- gsub("--[^\n]*", "", paste(readLines("docs/reference/views.sql"), collapse = "\n"))
for (statement in strsplit(sql, ";")[[1]]) if (grepl("\\S", statement)) invisible(dbExecute(db, statement))
frame <- dbGetQuery(db, "SELECT run, replication, value FROM replications WHERE kpi = 'cost_per_part' ORDER BY replication")
invisible(dbDisconnect(db))
test <- t.test(frame$value[frame$run == 2], frame$value[frame$run == 1], paired = TRUE)
cat(sprintf("run %d: %.3f\n", 1:2, tapply(frame$value, frame$run, mean)), sep = "")
cat(sprintf("difference %.3f, 95 %% interval %.3f to %.3f\n", test$estimate, test$conf.int[1], test$conf.int[2]))
